// SPDX-License-Identifier: MIT
#pragma once

// The vector kernel of the free batch, free_lanes.cpp, as the rest of core sees it.

#include "batch_entries.hpp"
#include "interface.hpp"

#include <cstddef>

namespace stillpoint {

/// Where the lanes get their work.
class FreeLanesSource : public Interface {
 public:
  /// The next entries to run; an empty range where there are no more.
  virtual EntryRange next() = 0;

  /// Asked now and then: when it returns false the results are no longer wanted.
  [[nodiscard]] virtual bool goes_on() = 0;

  /// Runs one entry by the scalar kernel: closed forms, and all entries that are not ordinary.
  virtual void run_alone(std::ptrdiff_t entry) = 0;
};

/// Runs all entries of `source`, by the widest instruction set of this machine. docs/batch.md.
void run_free_lanes(const BatchEntries& entries, double half_cycle_limit,
                    const FreeLanesOutput& output, FreeLanesSource& source);

}  // namespace stillpoint
