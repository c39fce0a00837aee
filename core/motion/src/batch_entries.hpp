// SPDX-License-Identifier: MIT
#pragma once

// The entries of a batch, and where their results go. Plain pointers only: free_lanes.cpp is
// compiled once for each instruction set, and inline code from other headers has no place in it.

#include <stillpoint/core/state.hpp>

#include <cstddef>

namespace stillpoint {

/// A value for all entries (stride 0) or one for each (stride 1).
struct EntryValues {
  const double* data{nullptr};
  std::ptrdiff_t stride{0};

  double operator[](std::ptrdiff_t i) const { return data[i * stride]; }
};

inline constexpr double no_damping = 0;

struct BatchEntries {
  EntryValues v0{};
  EntryValues p{};
  EntryValues f{};
  EntryValues delta{};
  std::ptrdiff_t size{0};
  EntryValues notch_width{};  ///< if given, for each entry
  EntryValues zeta{&no_damping, 0};
};

struct EntryRange {
  std::ptrdiff_t begin;
  std::ptrdiff_t end;
};

/// Entry i goes to place i of each array.
struct FreeLanesOutput {
  double* peak_amplitude;
  double* half_cycles;
  Outcome* outcome;
  double* stop_position;
  double* stop_time;  ///< null: not requested
};

}  // namespace stillpoint
