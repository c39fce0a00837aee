// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/surface.hpp>

#include <fmt/format.h>

#include <cstddef>
#include <string>

namespace stillpoint {

namespace {

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

}  // namespace

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
