// SPDX-License-Identifier: MIT
#include <stillpoint/design/prediction.hpp>

#include "region/edges.hpp"
#include "unit_problem.hpp"
#include "way/unit_strip.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/strips.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::design {

namespace {

/// The peaks are those of the first departure; the end is that of the given course.
Prediction predict_end(const Problem& problem, double a, double phase, double arrival_speed,
                       double half_cycles, double position) {
  return {.peak_amplitude = unit::peak(a) * problem.v0 / problem.p,
          .peak_acceleration = unit::radius(a) * problem.v0 * problem.p,
          .stop_time = phase / problem.p,
          .arrival_speed = arrival_speed * problem.v0,
          .half_cycles = half_cycles,
          .stop_position = position * problem.v0 / problem.p};
}

}  // namespace

Prediction predict(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, edges(problem, {}).f3);
  const double a = std::min(f / problem.p / problem.v0, unit::a3);
  return predict_end(problem, a, unit::stop_phase(a), unit::arrival_speed(a), 1, 0);
}

Prediction predict(const Problem& problem, double f, double delta) {
  const double a = f / problem.p / problem.v0;
  const double d = delta / problem.v0 / problem.v0;
  if (!is_plain(problem, {})) {  // wherever the strongest hit comes to rest
    const auto rest = unit::rest(a, d, static_cast<int>(problem.arrivals));
    return predict_end(problem, a, rest.phase, rest.arrival_speed, rest.half_cycles, rest.position);
  }
  const auto arrival = arrival_of(problem, f, delta);
  if (!arrival) {
    throw InputError("f, delta", fmt::format("{}, {}", f, delta),
                     fmt::format("must stop at one of the first {} arrivals", problem.arrivals));
  }
  if (*arrival == 1) {
    return predict(problem, f);
  }
  const auto course = unit::course(static_cast<int>(*arrival), a, d);
  return predict_end(problem, a, course.phase, course.arrival_speed, static_cast<double>(*arrival),
                     0);
}

}  // namespace stillpoint::design
