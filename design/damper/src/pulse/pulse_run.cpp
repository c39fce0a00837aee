// SPDX-License-Identifier: MIT
#include "pulse/first_return.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/forced_motion.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// By the forced run of core, without a slope.
FirstReturn forced_return(const Pulse& unit, double f, double zeta) {
  const ForcedResponse motion = forced_response({1, f, unpassable, {}, zeta}, {}, excitation(unit));
  const double speed = motion.arrival_speed.value_or(0);
  const double rest = std::abs(motion.stop_position.value_or(0));
  FirstReturn found;
  found.f = f;
  found.returns = motion.stops_at_zero && motion.half_cycles == 1.0;
  found.peak = motion.peak_amplitude;
  found.speed = speed;
  found.time = motion.stop_time.value_or(0);
  found.acceleration = figures_of(motion).acceleration;
  found.turns = motion.turning_points.value_or(0);
  found.exact_need = speed * speed / 2;
  found.published_need = (speed * speed + f * f) / 2;
  found.clearance = speed > 0 ? speed * speed : rest * (rest - 2 * f);
  return found;
}

}  // namespace

Pulse unit_pulse(const Pulse& pulse, double p) {
  return with(pulse, 1, angular_frequency(pulse) / p);
}

void take_worse(FirstReturn& worst, const FirstReturn& other) {
  worst.returns = worst.returns && other.returns;
  for (const auto figure : bounded_figures) {
    worst.*figure = std::max(worst.*figure, other.*figure);
  }
}

FirstReturn first_return(const Pulse& pulse, double p, double f, double zeta) {
  cancellation_point();
  const Pulse unit = unit_pulse(pulse, p);
  if (zeta == 0) {
    if (const auto closed = closed_return(unit, f)) {
      return *closed;
    }
  }
  FirstReturn motion = forced_return(unit, f, zeta);
  constexpr double aside = 1e-6;  // half of the digits
  motion.need_slope =
      (motion.exact_need - forced_return(unit, f * (1 - aside), zeta).exact_need) / (f * aside);
  return motion;
}

FirstReturn rescaled(FirstReturn motion, double k, double p) {
  if (k == 1 && p == 1) {
    return motion;
  }
  const double length = k / p / p;
  motion.f *= k;
  motion.peak *= length;
  motion.speed *= length * p;
  motion.time /= p;
  motion.acceleration *= k;
  motion.exact_need *= length * k;
  motion.published_need *= length * k;
  motion.need_slope *= length;
  motion.clearance *= length * k;
  motion.shortfall *= length * k;
  return motion;
}

}  // namespace stillpoint::design
