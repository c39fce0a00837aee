// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace stillpoint::records {

namespace {

using enum Dimension;

constexpr std::string_view percent = "%";

constexpr double pound = 0.45359237;  // in kg, an inch in cm and a pound-force in N: exact
constexpr double inch = 2.54;
constexpr double foot = 12 * inch;
constexpr double pound_force = pound * standard_gravity_m_per_s2;
constexpr double in_g = 1 / standard_gravity_m_per_s2;

constexpr std::array unit_table{
    // name, dimension, power of ten; the SI unit of each dimension first
    Unit{"m", length, 0},
    Unit{"cm", length, -2},
    Unit{"mm", length, -3},
    Unit{"in", length, -2, inch},
    Unit{"ft", length, -2, foot},
    Unit{"m/s", velocity, 0},
    Unit{"cm/s", velocity, -2},
    Unit{"mm/s", velocity, -3},
    Unit{"in/s", velocity, -2, inch},
    Unit{"ft/s", velocity, -2, foot},
    Unit{"s", time, 0},
    Unit{"ms", time, -3},
    Unit{"Hz", frequency, 0},
    Unit{"mHz", frequency, -3},
    Unit{"kHz", frequency, 3},
    Unit{"kg", mass, 0},
    Unit{"g", mass, -3},
    Unit{"t", mass, 3},
    Unit{"lb", mass, 0, pound},
    Unit{"kip", mass, 3, pound},  // of weight
    Unit{"N/m", stiffness, 0},
    Unit{"kN/m", stiffness, 3},
    Unit{"MN/m", stiffness, 6},
    Unit{"N/mm", stiffness, 3},
    Unit{"kN/mm", stiffness, 6},
    Unit{"lbf/in", stiffness, 2, pound_force / inch},
    Unit{"kip/in", stiffness, 5, pound_force / inch},
    Unit{"m/s2", acceleration, 0},
    Unit{"cm/s2", acceleration, -2},
    Unit{"mm/s2", acceleration, -3},
    Unit{"gal", acceleration, -2},
    Unit{"in/s2", acceleration, -2, inch},
    Unit{"g", gravities, 0},
    Unit{"m/s2", gravities, 0, in_g},
    Unit{"cm/s2", gravities, -2, in_g},
    Unit{"gal", gravities, -2, in_g},
    Unit{"in/s2", gravities, -2, inch* in_g},
    Unit{"N", force, 0},
    Unit{"kN", force, 3},
    Unit{"MN", force, 6},
    Unit{"lbf", force, 0, pound_force},
    Unit{"kip", force, 3, pound_force},
    Unit{"J", energy, 0},
    Unit{"kJ", energy, 3},
    Unit{"MJ", energy, 6},
    Unit{"lbf-in", energy, -2, pound_force* inch},
    Unit{"kip-in", energy, 1, pound_force* inch},
    Unit{"lbf-ft", energy, -2, pound_force* foot},
    Unit{"kip-ft", energy, 1, pound_force* foot},
    Unit{percent, share, -2},
};

/// A text divided into a number and the unit behind it.
struct Parts {
  std::string_view number;
  std::string_view unit;
};

/// Empty where it does not begin with a finite number. Between number and unit may be blanks.
std::optional<Parts> divided(std::string_view text) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  if (text.substr(sign).find_first_of("0123456789.") > 1) {
    return std::nullopt;  // inf, nan
  }
  double ignored = 0;
  const char* const end = text.data() + text.size();
  const char* const stop = std::from_chars(text.data() + sign, end, ignored).ptr;
  if (stop == text.data() + sign) {
    return std::nullopt;
  }
  const auto length = static_cast<std::size_t>(stop - text.data());
  std::string_view unit = text.substr(length);
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  return Parts{text.substr(0, length), unit};
}

/// The number times the power of ten, in digits: its exponent is moved.
std::string moved(std::string_view number, int power_of_ten) {
  const std::size_t e = number.find_first_of("eE");
  long long exponent = 0;
  if (e != std::string_view::npos) {
    std::string_view digits = number.substr(e + 1);
    if (digits.starts_with('+')) {
      digits.remove_prefix(1);
    }
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc()) {
      return std::string(number);  // beyond any double, and reported as such
    }
  }
  constexpr long long far = 1'000'000'000;
  return fmt::format("{}e{}", number.substr(0, e), std::clamp(exponent, -far, far) + power_of_ten);
}

}  // namespace

std::vector<Unit> units_of(Dimension dimension) {
  std::vector<Unit> accepted;
  std::ranges::copy_if(unit_table, std::back_inserter(accepted),
                       [dimension](const Unit& unit) { return unit.dimension == dimension; });
  return accepted;
}

std::string unit_names(Dimension dimension) {
  std::vector<std::string_view> list;
  for (const Unit& unit : units_of(dimension)) {
    list.push_back(unit.name);
  }
  return list.empty() ? "" : list.size() == 1 ? std::string(list.front()) : listed(list);
}

double parse_value(std::string_view field, Dimension dimension, std::string_view text,
                   std::string_view instead) {
  const auto parts = divided(text);
  if (!parts || parts->unit.empty() ||
      (dimension == none && (!is_unit(parts->unit) || parts->unit == percent))) {
    return parse_number(field, text);
  }
  const std::vector<Unit> accepted = units_of(dimension);
  const auto unit = std::ranges::find(accepted, parts->unit, &Unit::name);
  if (unit == accepted.end()) {
    throw InputError(std::string(field), quoted(text),
                     accepted.empty() ? fmt::format("must be a number without a unit{}", instead)
                     : dimension == share
                         ? "must be a number, or one in %: 5% is 0.05; a range is 5%:10%"
                     : accepted.size() == 1
                         ? fmt::format("must be a number in {0}, with or without the unit {0}",
                                       accepted.front().name)
                         : fmt::format("must be a number in {}, or have the unit {}{}",
                                       accepted.front().name, unit_names(dimension), instead));
  }
  const auto scanned = scan_number(moved(parts->number, unit->power_of_ten));
  if (scanned.fault != NumberFault::none) {
    throw InputError(std::string(field), std::string(text),
                     "must have a magnitude that a double can hold, 2.2e-308 to 1.8e308");
  }
  return scanned.value * unit->times;
}

void require_physical(std::string_view field, Dimension dimension, double value, double least) {
  if (value >= least && value <= largest_physical) {
    return;
  }
  const std::vector<Unit> units = units_of(dimension);
  const std::string unit = units.empty() ? "" : fmt::format(" {}", units.front().name);
  throw InputError(std::string(field), fmt::format("{}{}", value, unit),
                   fmt::format("must be from {} to {}{}", least, largest_physical, unit));
}

bool is_unit(std::string_view text) {
  return std::ranges::find(unit_table, text, &Unit::name) != unit_table.end();
}

bool has_unit(std::string_view text) {
  const auto parts = divided(text);
  return parts && !parts->unit.empty();
}

bool is_customary(std::string_view text) {
  const auto parts = divided(text);
  return parts &&
         std::ranges::any_of(std::array<std::string_view, 4>{"in", "ft", "lb", "kip"},
                             [&](std::string_view unit) { return parts->unit.starts_with(unit); });
}

bool has_unit(std::string_view text, Dimension dimension) {
  const auto parts = divided(text);
  const std::vector<Unit> units = units_of(dimension);
  return parts && std::ranges::find(units, parts->unit, &Unit::name) != units.end();
}

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
