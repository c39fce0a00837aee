// SPDX-License-Identifier: MIT
#include "sqrt_floor.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#ifndef STILLPOINT_SQRT_FLOOR_SIZES  // the file is compiled several times
#define STILLPOINT_SQRT_FLOOR_SIZES
namespace stillpoint::bench {
namespace {
constexpr std::size_t count = 1024;  // in and out lie within any first-level cache
constexpr int repeats = 100;
}  // namespace
}  // namespace stillpoint::bench
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sqrt_floor.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stillpoint::bench::HWY_NAMESPACE {

namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// in and out hold `count` doubles. No root depends on another.
void square_roots(const double* in, double* out) {
  const hn::CappedTag<double, 8> d;
  const auto width = hn::Lanes(d);
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < count; i += width) {
      hn::StoreU(hn::Sqrt(hn::LoadU(d, in + i)), d, out + i);
    }
    static_cast<void>(static_cast<const volatile double*>(out)[repeat]);  // keeps the repeats
  }
}

}  // namespace

}  // namespace stillpoint::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace stillpoint::bench {

namespace {
HWY_EXPORT(square_roots);
}  // namespace

double sqrt_floor() {
  using Clock = std::chrono::steady_clock;
  HWY_ALIGN std::array<double, count> in{};
  HWY_ALIGN std::array<double, count> out{};
  for (std::size_t i = 0; i < count; ++i) {
    in[i] = 0.001 * static_cast<double>(i + 1);
  }
  double shortest = 1e300;
  for (int run = 0; run < 20; ++run) {
    const auto begin = Clock::now();
    HWY_DYNAMIC_DISPATCH(square_roots)(in.data(), out.data());
    const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
    shortest = std::min(shortest, time.count() / (count * repeats));
  }
  return shortest;
}

}  // namespace stillpoint::bench
#endif
