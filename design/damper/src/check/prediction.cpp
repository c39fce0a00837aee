// SPDX-License-Identifier: MIT
#include <stillpoint/design/prediction.hpp>

#include "check/rest.hpp"
#include "region/edges.hpp"
#include "unit_problem.hpp"
#include "way/unit_strip.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/strips.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::design {

Prediction predict(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, edges(problem, {}).f3);
  const double a = std::min(f / problem.p / problem.v0, unit::a3);
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = unit::stop_phase(a) / problem.p;
  prediction.arrival_speed = unit::arrival_speed(a) * problem.v0;
  return prediction;
}

namespace {

/// The place where the strongest hit comes to rest, whichever it is.
Prediction predict_rest(const Problem& problem, double f, double delta) {
  const double a = f / problem.p / problem.v0;
  const auto rest =
      unit::rest(a, delta / problem.v0 / problem.v0, static_cast<int>(problem.arrivals));
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = rest.phase / problem.p;
  prediction.arrival_speed = rest.arrival_speed * problem.v0;
  prediction.half_cycles = rest.half_cycles;
  prediction.stop_position = rest.position * problem.v0 / problem.p;
  return prediction;
}

}  // namespace

Prediction predict(const Problem& problem, double f, double delta) {
  if (!is_plain(problem, {})) {
    return predict_rest(problem, f, delta);
  }
  const auto arrival = arrival_of(problem, f, delta);
  if (!arrival) {
    throw InputError("f, delta", fmt::format("{}, {}", f, delta),
                     fmt::format("must stop at one of the first {} arrivals", problem.arrivals));
  }
  if (*arrival == 1) {
    return predict(problem, f);
  }
  const double a = f / problem.p / problem.v0;
  const auto course = unit::course(static_cast<int>(*arrival), a, delta / problem.v0 / problem.v0);
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = course.phase / problem.p;
  prediction.arrival_speed = course.arrival_speed * problem.v0;
  prediction.half_cycles = static_cast<double>(*arrival);
  return prediction;
}

}  // namespace stillpoint::design
