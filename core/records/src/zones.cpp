// SPDX-License-Identifier: MIT
#include <stillpoint/records/zones.hpp>

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

namespace stillpoint::records {

std::vector<FrictionZone> parse_zones(std::string_view field, Dimension edge,
                                      std::string_view text) {
  const std::vector<std::string_view> parts = split(text, ',');
  std::vector<FrictionZone> zones;
  zones.reserve(parts.size());
  std::string_view before;
  for (const std::string_view zone : parts) {
    const std::string place = fmt::format("{} {}", field, zones.size() + 1);
    const std::size_t colon = zone.find(':');
    if (colon == std::string_view::npos) {
      throw InputError(place, std::string(zone), "must be X:F, an edge and the friction up to it");
    }
    const std::string_view to = zone.substr(0, colon);
    zones.push_back({parse_value(place + ": to", edge, to),
                     parse_number(place + ": f", zone.substr(colon + 1))});
    // The core checks this too, but knows no units.
    if (zones.size() > 1 && !(zones.back().to > zones[zones.size() - 2].to)) {
      throw InputError(place + ": to", std::string(to),
                       fmt::format("must be greater than the previous edge, {}", before));
    }
    before = to;
  }
  return zones;
}

}  // namespace stillpoint::records
