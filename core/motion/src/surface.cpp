// SPDX-License-Identifier: MIT
#include "require.hpp"

#include <stillpoint/core/surface.hpp>

#include <cstddef>
#include <string>

namespace stillpoint {

namespace {

/// A length and p times it.
void require_length(const std::string& field, double value, double p) {
  require_within(field, value, smallest_speed, largest_speed);
  const double speed = p * value;
  require(speed >= smallest_speed && speed <= largest_speed, field, value,
          "its product with p must be from {} to {} (p = {})", smallest_speed, largest_speed, p);
}

}  // namespace

void require_valid(const Oscillator& oscillator, const Surface& surface) {
  const double p = oscillator.p;
  if (surface.notch_width) {
    const double width = *surface.notch_width;
    require_length("notch-width", width, p);
    require(!oscillator.hold, "hold", oscillator.hold.value_or(0),
            "a notch with a width holds by its own friction: give either hold or notch-width");
    require(oscillator.delta / width / p <= largest_speed, "notch-width", width,
            "delta / width / p must be at most {} (delta = {}, p = {})", largest_speed,
            oscillator.delta, p);
  }
  double before = 0;
  for (std::size_t i = 0; i < surface.zones.size(); ++i) {
    const FrictionZone& zone = surface.zones[i];
    const std::string name = fmt::format("friction-zones {}", i + 1);
    require_length(name + ": to", zone.to, p);
    require(zone.to > before && p * zone.to > p * before, name + ": to", zone.to,
            "must be greater than the previous edge, {}", before);
    require_friction(name + ": f", zone.f, p);
    before = zone.to;
  }
}

}  // namespace stillpoint
