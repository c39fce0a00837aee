// SPDX-License-Identifier: MIT
#include "comparison.hpp"

#include "sqrt_floor.hpp"

#include <stillpoint/core/free_motion.hpp>

#include <cmath>
#include <cstddef>

namespace stillpoint::bench {

namespace {

/// Each of the previous one plus 1: the floor for a chain of half-cycles.
double chained_roots(double from) {
  for (std::size_t i = 0; i < roots_at_once; ++i) {
    from = std::sqrt(from + 1);
  }
  return from;
}

}  // namespace

void scale(peers::Timing& timing, double by) {
  timing.median *= by;
  timing.low *= by;
  timing.high *= by;
}

std::vector<Unit> free_modes(const peers::Scene& scene, const peers::MeasureOptions& options) {
  volatile double sink = 0;
  SquareRoots numbers{};
  SquareRoots answers{};
  numbers.fill(2);
  const auto response = [&](bool times, bool margin) {
    return [&, times, margin] {
      sink = free_response(scene.oscillator, scene.start, {.times = times, .margin = margin})
                 .peak_amplitude;
    };
  };
  const std::vector<std::function<void()>> calls{
      response(false, false),
      response(true, false),
      response(true, true),
      [&] { sink = free_peak(scene.oscillator, scene.start); },
      [&] { sink = chained_roots(numbers[0]); },
      [&] {
        square_roots(numbers, answers);
        sink = answers[roots_at_once / 2];
      },
  };
  const double half_cycles = free_response(scene.oscillator, scene.start).half_cycles.value();
  std::vector<peers::Timing> timings = measure(calls, options);
  for (std::size_t i = 0; i < 3; ++i) {
    scale(timings[i], 1 / half_cycles);
  }
  scale(timings[4], 1.0 / roots_at_once);
  scale(timings[5], 1.0 / roots_at_once);
  return {{"a half-cycle, counts and peaks only", timings[0]},
          {"a half-cycle, with times", timings[1]},
          {"a half-cycle, with times and decision margin", timings[2]},
          {"free_peak, a whole motion", timings[3]},
          {"hardware square root and a sum, each waiting for the last", timings[4]},
          {"hardware square root, in vectors", timings[5]}};
}

}  // namespace stillpoint::bench
