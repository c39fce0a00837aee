// SPDX-License-Identifier: MIT
#pragma once

// Random tasks with a pulse, and the judgement of a damper by its own motion.

#include "random_source.hpp"

#include <stillpoint/design.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace stillpoint::design_test {

/// Its motion from rest, over a notch of that capacity.
inline ForcedResponse simulated(const design::PulseProblem& problem, double f, double delta) {
  return forced_response({problem.p, f, delta}, {}, design::excitation(problem.pulse));
}

/// By that motion, without a tolerance and by the exact criterion.
inline bool admissible(const design::PulseRequest& request, double f, double delta) {
  const auto& [problem, limits, search] = request;
  const ForcedResponse motion = simulated(problem, f, delta);
  return motion.stops_at_zero && motion.half_cycles == 1.0 &&
         motion.peak_amplitude <= problem.beta && f <= limits.f_max.value_or(HUGE_VAL) &&
         delta <= limits.delta_max.value_or(HUGE_VAL) &&
         motion.peak_absolute_acceleration <= limits.acceleration_max.value_or(HUGE_VAL);
}

inline design::Pulse pulse_of(int kind, double k, double lambda) {
  switch (kind) {
    case 0:
      return HalfSine{k, lambda};
    case 1:
      return Rectangle{k, lambda};
    default:
      return FullSine{k, lambda};
  }
}

inline design::Pulse random_pulse(RandomSource& random, double k, double lambda) {
  return pulse_of(random.pick(3), k, lambda);
}

inline design::PulseRequest random_request(RandomSource& random) {
  const double p = random.log_uniform(1e-2, 1e2);
  const double k = random.log_uniform(1e-2, 1e2);
  design::PulseRequest request;
  request.problem = {random_pulse(random, k, p / random.log_uniform(0.02, 5)), p, 1,
                     random.pick(2) == 0 ? design::Criterion::published : design::Criterion::exact};
  const ForcedResponse free = simulated(request.problem, 1e-3 * k, 1e200);
  request.problem.beta = random.uniform(0.35, 1.2) * free.peak_amplitude;
  random.one_in(2, request.limits.tolerance, [&] { return random.uniform(0, 0.3); });
  random.one_in(4, request.limits.f_max,
                [&] { return random.uniform(0.05, 0.5) * free.peak_absolute_acceleration; });
  if (random.pick(4) == 0) {
    const double w = free.arrival_speed.value_or(0);
    request.limits.delta_max = random.uniform(0.2, 1.5) * w * w / 2;
  }
  random.one_in(4, request.limits.acceleration_max,
                [&] { return random.uniform(0.8, 1.5) * free.peak_absolute_acceleration; });
  request.search.objective = random_objective(random);
  return request;
}

}  // namespace stillpoint::design_test
