// SPDX-License-Identifier: MIT
#include "input/motion.hpp"

#include <nlohmann/json.hpp>

namespace stillpoint::cli {

namespace {

constexpr std::string_view zones_name = "friction-zones";

double in_units(double value, const Physical& physical) {
  return physical ? value / physical->scales.length_m : value;
}

}  // namespace

std::string zones_text(const nlohmann::json& list) {
  if (list.empty()) {
    throw InputError(std::string(zones_name), "[]", "must have at least one zone");
  }
  std::string text;
  for (const nlohmann::json& zone : list) {
    const auto value = [&zone](const char* key) {
      return zone.is_object() && zone.contains(key) ? zone[key] : nlohmann::json();
    };
    const nlohmann::json to = value("to");
    const nlohmann::json f = value("f");
    const std::string with_unit = to.is_string() ? to.get<std::string>() : "";
    const bool is_edge = to.is_number() || (has_unit(with_unit) &&
                                            with_unit.find_first_of(":,") == std::string::npos);
    if (zone.size() != 2 || !is_edge || !f.is_number()) {
      throw InputError(std::string(zones_name), zone.dump(),
                       R"(each zone must be {"to": X, "f": F})");
    }
    text += fmt::format("{}{}:{}", text.empty() ? "" : ",",
                        to.is_number() ? fmt::format("{}", to.get<double>()) : with_unit,
                        f.get<double>());
  }
  return text;
}

std::optional<double> notch_width(const Settings& settings, const Physical& physical) {
  if (const auto width = settings.number("notch-width-m")) {
    if (!(*width > 0)) {
      throw InputError("notch-width-m", *width, "must be a number greater than 0");
    }
    return in_units(*width, physical);
  }
  return settings.number("notch-width");
}

std::vector<FrictionZone> friction_zones(const Settings& settings, const Physical& physical) {
  std::vector<FrictionZone> zones;
  if (const auto text = settings.text(zones_name)) {
    zones = records::parse_zones(zones_name, physical ? Dimension::length : Dimension::none, *text);
    for (FrictionZone& zone : zones) {
      zone.to = in_units(zone.to, physical);
    }
  }
  return zones;
}

Surface surface_input(const Settings& settings, const Physical& physical) {
  return {notch_width(settings, physical), friction_zones(settings, physical)};
}

}  // namespace stillpoint::cli
