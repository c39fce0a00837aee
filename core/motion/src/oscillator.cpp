// SPDX-License-Identifier: MIT
#include "require.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <cmath>
#include <string>

namespace stillpoint {

namespace {

void require_speed(const char* field, double value, double speed, const char* what) {
  const double magnitude = std::abs(speed);
  require(magnitude == 0 || (magnitude >= smallest_speed && magnitude <= largest_speed), field,
          value, "{} must be 0 or have a magnitude from {} to {}", what, smallest_speed,
          largest_speed);
}

}  // namespace

void require_friction(const std::string& field, double f, double p) {
  require_within(field, f, 0, largest_speed * p);
  require(!(f != 0 && f / p < smallest_friction_speed), field, f,
          "must be 0 or at least {} p (p = {})", smallest_friction_speed, p);
}

void require_valid(const Oscillator& oscillator) {
  require_within("p", oscillator.p, smallest_speed, largest_speed);
  require_friction("f", oscillator.f, oscillator.p);
  require_within("delta", oscillator.delta, 0, largest_square);
  if (oscillator.hold) {
    require_friction("hold", *oscillator.hold, oscillator.p);
  }
  if (!oscillator.coulomb()) {
    require_within("damping", oscillator.zeta, 0, largest_zeta);
    require_within("breakaway", oscillator.breakaway, 1, largest_breakaway);
  }
}

void require_valid(const Oscillator& oscillator, const Start& start) {
  require_valid(oscillator);
  require_within("x0", start.x0, -largest_square, largest_square);
  require_within("v0", start.v0, -largest_speed, largest_speed);
  require_speed("v0", start.v0, start.v0, "v0");
  require_speed("x0", start.x0, oscillator.p * start.x0, "p * x0");
  const double phi = oscillator.f / oscillator.p;
  const double speed = std::abs(start.v0);
  require(!(speed > 0 && phi > speed && speed * (speed / phi) < smallest_peak_speed), "f",
          oscillator.f, "v0^2 p / f must be at least {} (v0 = {}, p = {})", smallest_peak_speed,
          start.v0, oscillator.p);
  require(!(start.x0 != 0 && oscillator.p * start.x0 == 0), "x0", start.x0,
          "p * x0 must not underflow (p = {})", oscillator.p);
}

}  // namespace stillpoint
