// SPDX-License-Identifier: MIT
#include "pulse/leg.hpp"

namespace stillpoint::design {

namespace {

Pulse with_lambda(Pulse pulse, double lambda) {
  std::visit([&](auto& kind) { kind.lambda = lambda; }, pulse);
  return pulse;
}

}  // namespace

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

Pulse Leg::pulse_at(double s) const {
  return softens ? first : with_lambda(first, angular_frequency(first) * s);
}

FirstReturn Leg::at(double s, double f) const {
  return rescaled(first_return(pulse_at(s), p_at(s), f), 1, p_at(s));
}

}  // namespace stillpoint::design
