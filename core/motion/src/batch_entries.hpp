// SPDX-License-Identifier: MIT
#pragma once

// The entries of a batch. Plain pointers only: free_lanes.cpp is compiled once for each instruction
// set, and inline code from other headers has no place in it.

#include <cstddef>

namespace stillpoint {

/// A value for all entries (stride 0) or one for each (stride 1).
struct EntryValues {
  const double* data;
  std::ptrdiff_t stride;

  double operator[](std::ptrdiff_t i) const { return data[i * stride]; }
};

struct BatchEntries {
  EntryValues v0;
  EntryValues p;
  EntryValues f;
  EntryValues delta;
  std::ptrdiff_t size;
};

struct EntryRange {
  std::ptrdiff_t begin;
  std::ptrdiff_t end;
};

}  // namespace stillpoint
