// SPDX-License-Identifier: MIT
#pragma once

// What the vector kernel of the free batch works on. Plain pointers only: free_lanes.cpp is
// compiled once for each instruction set, and inline code from other headers has no place in it.

#include <stillpoint/core/outcome.hpp>

#include <cstddef>

namespace stillpoint {

/// A value for all entries (stride 0) or one for each (stride 1).
struct EntryValues {
  const double* data;
  std::ptrdiff_t stride;

  double operator[](std::ptrdiff_t i) const { return data[i * stride]; }
};

struct FreeLanesInput {
  EntryValues v0;
  EntryValues p;
  EntryValues f;
  EntryValues delta;
  double half_cycle_limit;
};

/// Entry i goes to place i of each array.
struct FreeLanesOutput {
  double* peak_amplitude;
  double* half_cycles;
  Outcome* outcome;
  double* stop_position;
  double* stop_time;  ///< null: not asked for
};

struct EntryRange {
  std::ptrdiff_t begin;
  std::ptrdiff_t end;
};

/// Where the lanes get their work.
class FreeLanesSource {
 public:
  /// The next entries to run; an empty range where there are no more.
  virtual EntryRange next() = 0;

  /// Runs one entry by the scalar kernel: those that take no loop, and all that are not ordinary.
  virtual void run_alone(std::ptrdiff_t entry) = 0;

 protected:
  ~FreeLanesSource() = default;
};

/// Runs all entries of `source`, by the widest instruction set of this machine. docs/batch.md.
void run_free_lanes(const FreeLanesInput& input, const FreeLanesOutput& output,
                    FreeLanesSource& source);

}  // namespace stillpoint
