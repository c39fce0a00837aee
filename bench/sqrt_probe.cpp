// SPDX-License-Identifier: MIT
#include "sqrt_probe.hpp"

#include <cmath>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define STILLPOINT_WIDEST_VECTORS __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define STILLPOINT_WIDEST_VECTORS
#endif

namespace stillpoint::bench {

namespace {

STILLPOINT_WIDEST_VECTORS void all_roots(const double* from, double* to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = std::sqrt(from[i]);
  }
}

}  // namespace

void vector_sqrt(std::span<const double> from, std::span<double> to) {
  all_roots(from.data(), to.data(), from.size());
}

double chained_sqrt(double from, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    from = std::sqrt(from + 1);
  }
  return from;
}

}  // namespace stillpoint::bench
