// SPDX-License-Identifier: MIT
#include "surface_input.hpp"

#include <stillpoint/core/input_error.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

namespace {

constexpr std::string_view zones_name = "friction-zones";

/// Of "x:f,x:f,...".
std::vector<FrictionZone> parse_zones(std::string_view text) {
  std::vector<FrictionZone> zones;
  for (bool more = true; more;) {
    const std::size_t comma = text.find(',');
    const std::string_view zone = text.substr(0, comma);
    const std::size_t colon = zone.find(':');
    const std::string field = fmt::format("{} {}", zones_name, zones.size() + 1);
    if (colon == std::string_view::npos) {
      throw InputError(field, std::string(zone), "must be X:F, an edge and the friction up to it");
    }
    zones.push_back({parse_number(field + ": to", zone.substr(0, colon)),
                     parse_number(field + ": f", zone.substr(colon + 1))});
    more = comma != std::string_view::npos;
    text.remove_prefix(more ? comma + 1 : text.size());
  }
  return zones;
}

double in_units(double value, const std::optional<design::PhysicalInput>& physical) {
  return physical ? value / physical->scales.length_m : value;
}

}  // namespace

std::string zones_text(const nlohmann::json& list) {
  std::string text;
  for (const nlohmann::json& zone : list) {
    const auto has = [&zone](const char* key) {
      return zone.contains(key) && zone[key].is_number();
    };
    if (!zone.is_object() || zone.size() != 2 || !has("to") || !has("f")) {
      throw InputError(std::string(zones_name), zone.dump(),
                       R"(each zone must be {"to": X, "f": F})");
    }
    text += fmt::format("{}{}:{}", text.empty() ? "" : ",", zone["to"].get<double>(),
                        zone["f"].get<double>());
  }
  return text;
}

std::optional<double> notch_width(const Settings& settings,
                                  const std::optional<design::PhysicalInput>& physical) {
  if (const auto width = settings.number("notch-width-m")) {
    if (!(*width > 0)) {
      throw InputError("notch-width-m", *width, "must be a number greater than 0");
    }
    return in_units(*width, physical);
  }
  return settings.number("notch-width");
}

Surface surface_input(const Settings& settings,
                      const std::optional<design::PhysicalInput>& physical) {
  Surface surface;
  surface.notch_width = notch_width(settings, physical);
  if (const auto text = settings.text(zones_name)) {
    surface.zones = parse_zones(*text);
    for (FrictionZone& zone : surface.zones) {
      zone.to = in_units(zone.to, physical);
    }
  }
  return surface;
}

void require_paper_notch(const Settings& settings, Command command) {
  for (const std::string_view option : {"hold", "notch-width", "notch-width-m", "friction-zones"}) {
    if (settings.has(option)) {
      throw UsageError(
          fmt::format("{} is not for {}, which computes the paper's notch and a constant f", option,
                      name(command)));
    }
  }
}

}  // namespace stillpoint::cli
