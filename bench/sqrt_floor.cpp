// SPDX-License-Identifier: MIT
#include "sqrt_floor.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sqrt_floor.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stillpoint::bench::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

void roots(const double* in, double* out) {
  const hn::CappedTag<double, 8> d;
  for (std::size_t i = 0; i < roots_at_once; i += hn::Lanes(d)) {
    hn::StoreU(hn::Sqrt(hn::LoadU(d, in + i)), d, out + i);
  }
}

}  // namespace

}  // namespace stillpoint::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stillpoint::bench {

namespace {
HWY_EXPORT(roots);
}  // namespace

void square_roots(const SquareRoots& in, SquareRoots& out) {
  HWY_DYNAMIC_DISPATCH(roots)(in.data(), out.data());
}

double sqrt_floor() {
  using Clock = std::chrono::steady_clock;
  constexpr int runs = 20;
  constexpr int repeats = 100;
  HWY_ALIGN SquareRoots in{};
  HWY_ALIGN SquareRoots out{};
  std::iota(in.begin(), in.end(), 1.0);
  double shortest = 1e300;
  for (int run = 0; run < runs; ++run) {
    const auto begin = Clock::now();
    for (int repeat = 0; repeat < repeats; ++repeat) {
      square_roots(in, out);
    }
    const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
    shortest = std::min(shortest, time.count() / (roots_at_once * repeats));
  }
  return shortest;
}

}  // namespace stillpoint::bench
#endif
