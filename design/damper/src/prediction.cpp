// SPDX-License-Identifier: MIT
#include "unit_problem.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/region.hpp>

#include <algorithm>

namespace stillpoint::design {

Prediction predict(const Problem& problem, double f) {
  require_within("f", f, 0, admissible_region(problem).f3);
  const double a = std::min(f / problem.p / problem.v0, unit::a3);
  Prediction prediction;
  prediction.peak_amplitude = unit::peak(a) * problem.v0 / problem.p;
  prediction.peak_acceleration = unit::radius(a) * problem.v0 * problem.p;
  prediction.stop_time = unit::stop_phase(a) / problem.p;
  prediction.arrival_speed = unit::arrival_speed(a) * problem.v0;
  return prediction;
}

}  // namespace stillpoint::design
