// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/surface.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace stillpoint {

namespace {

void require_speed(const char* field, double value, double speed, const char* what) {
  const double magnitude = std::abs(speed);
  if (magnitude == 0 || (magnitude >= smallest_speed && magnitude <= largest_speed)) {
    return;
  }
  throw InputError(field, value,
                   fmt::format("{} must be 0 or have a magnitude from {} to {}", what,
                               smallest_speed, largest_speed));
}

/// A length and p times it.
void require_length(const std::string& field, double value, double p) {
  require_within(field, value, smallest_speed, largest_speed);
  const double speed = p * value;
  if (!(speed >= smallest_speed && speed <= largest_speed)) {
    throw InputError(field, value,
                     fmt::format("its product with p must be from {} to {} (p = {})",
                                 smallest_speed, largest_speed, p));
  }
}

/// A friction, or the load that a notch holds: 0, or f / p within the bounds of oscillator.hpp.
void require_friction(const std::string& field, double f, double p) {
  require_within(field, f, 0, largest_speed * p);
  if (f != 0 && f / p < smallest_friction_speed) {
    throw InputError(
        field, f, fmt::format("must be 0 or at least {} p (p = {})", smallest_friction_speed, p));
  }
}

}  // namespace

void require_valid(const Oscillator& oscillator) {
  require_within("p", oscillator.p, smallest_speed, largest_speed);
  require_friction("f", oscillator.f, oscillator.p);
  require_within("delta", oscillator.delta, 0, largest_square);
  if (oscillator.hold) {
    require_friction("hold", *oscillator.hold, oscillator.p);
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
  if (speed > 0 && phi > speed && speed * (speed / phi) < smallest_peak_speed) {
    throw InputError("f", oscillator.f,
                     fmt::format("v0^2 p / f must be at least {} (v0 = {}, p = {})",
                                 smallest_peak_speed, start.v0, oscillator.p));
  }
  if (start.x0 != 0 && oscillator.p * start.x0 == 0) {
    throw InputError("x0", start.x0,
                     fmt::format("p * x0 must not underflow (p = {})", oscillator.p));
  }
}

void require_valid(const Oscillator& oscillator, const Surface& surface) {
  const double p = oscillator.p;
  if (surface.notch_width) {
    const double width = *surface.notch_width;
    require_length("notch-width", width, p);
    if (oscillator.hold) {
      throw InputError(
          "hold", *oscillator.hold,
          "a notch with a width holds by its own friction: give either hold or notch-width");
    }
    const double wall = oscillator.delta / width;
    if (!(wall / p <= largest_speed)) {
      throw InputError("notch-width", width,
                       fmt::format("delta / width / p must be at most {} (delta = {}, p = {})",
                                   largest_speed, oscillator.delta, p));
    }
  }
  double before = 0;
  for (std::size_t i = 0; i < surface.zones.size(); ++i) {
    const FrictionZone& zone = surface.zones[i];
    const std::string name = fmt::format("friction-zones {}", i + 1);
    require_length(name + ": to", zone.to, p);
    if (!(zone.to > before && p * zone.to > p * before)) {
      throw InputError(name + ": to", zone.to,
                       fmt::format("must be greater than the previous edge, {}", before));
    }
    require_friction(name + ": f", zone.f, p);
    before = zone.to;
  }
}

}  // namespace stillpoint
