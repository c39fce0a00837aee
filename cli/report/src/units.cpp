// SPDX-License-Identifier: MIT
#include "units.hpp"
#include "format.hpp"

#include <stillpoint/records/units.hpp>
#include <stillpoint/report/digits.hpp>

#include <array>
#include <cmath>

namespace stillpoint::report {

std::string with_blank(const std::string& unit) {
  return unit.empty() ? "" : " " + unit;
}

std::string length_shown(const Physical& physical, double length, std::optional<int> digits) {
  return physical && length != 0
             ? si_words(physical, length * physical->scales.length_m, "m", digits.value_or(5))
             : format("{:.{}g}", length, digits.value_or(6));
}

std::string time_shown(const Physical& physical, double tau) {
  return physical ? with_unit(tau * physical->scales.time_s, "s") : "tau = " + digits(tau);
}

std::string acceleration_shown(double acceleration) {
  return format("{:.4g} g", acceleration);
}

std::string length_limit(const Physical& physical, double length, bool upwards,
                         std::optional<int> digits) {
  const Unit unit = units_of(physical).length;
  return limit_digits(length * unit, upwards, digits.value_or(physical ? 5 : 6)) +
         with_blank(unit.name);
}

std::string figure_shown(const Physical& physical, Dimension dimension, double value) {
  constexpr double least_m = 1e-6;  // the least that a report tells from 0
  const bool length = dimension == Dimension::length;
  return length && physical && value > 0 && value * physical->scales.length_m < least_m
             ? "less than " + si_words(physical, least_m, "m", 1)
         : length                            ? length_shown(physical, value)
         : dimension == Dimension::time      ? time_shown(physical, value)
         : dimension == Dimension::velocity  ? units_of(physical).velocity.words(value)
         : dimension == Dimension::gravities ? acceleration_shown(value)
                                             : format("{:.4g}", value);
}

std::string beyond(const Physical& physical, Dimension dimension, double value, double limit) {
  std::string now = figure_shown(physical, dimension, value);
  std::string allowed = figure_shown(physical, dimension, limit);
  const Unit unit = units_of(physical).of(dimension);
  for (int digits = 6; now == allowed && digits < digits_of_double; ++digits) {
    now = format("{:.{}g}{}", value * unit, digits, with_blank(unit.name));
    allowed = format("{:.{}g}{}", limit * unit, digits, with_blank(unit.name));
  }
  return format("{} where {} is allowed", now, allowed);
}

std::string Unit::words(double value) const {
  return few_digits(value * factor + 0.0) + with_blank(name);
}

std::string in(std::string_view name, const Unit& unit) {
  return format("{}{}{}", name, unit.name.empty() ? "" : ", ", unit.name);
}

namespace {

/// What is read in place of an SI unit: the larger one where a value has more than one of it.
struct Customary {
  std::string_view si;
  std::string_view name;
  Dimension dimension;
  std::string_view measure{name};  ///< of that dimension
};
constexpr std::array customary{Customary{"m", "in", Dimension::length},
                               Customary{"m/s", "in/s", Dimension::velocity},
                               Customary{"m/s²", "in/s²", Dimension::acceleration, "in/s2"},
                               Customary{"N/m", "kip/in", Dimension::stiffness},
                               Customary{"N/m", "lbf/in", Dimension::stiffness},
                               Customary{"N", "kip", Dimension::force},
                               Customary{"N", "lbf", Dimension::force},
                               Customary{"N s", "kip s", Dimension::force, "kip"},
                               Customary{"N s", "lbf s", Dimension::force, "lbf"},
                               Customary{"J", "kip-in", Dimension::energy},
                               Customary{"J", "lbf-in", Dimension::energy}};

std::optional<Unit> in_inches(std::string_view si, double most) {
  std::optional<Unit> read;
  for (const Customary& now : customary) {
    if (now.si == si && !(read && most * *read >= 1)) {
      const double one = records::parse_value("", now.dimension, format("1{}", now.measure));
      read = Unit{1 / one, std::string(now.name)};
    }
  }
  return read;
}

/// In the unit in which it has digits before the point.
Unit in_joules(double energy) {
  return energy >= 1e3 ? Unit{1e-3 * energy, "kJ"}
         : energy >= 1 ? Unit{energy, "J"}
                       : Unit{1e3 * energy, "mJ"};
}

/// The forces of an isolator are some hundredths of its weight.
Unit in_newtons(double weight) {
  return weight >= 1e4 ? Unit{1e-3 * weight, "kN"} : Unit{weight, "N"};
}

}  // namespace

Unit read_in(const Physical& physical, std::string_view unit, double most) {
  const Unit same{1, std::string(unit)};
  return physical && physical->inches ? in_inches(unit, most).value_or(same) : same;
}

std::string si_words(const Physical& physical, double value, std::string_view unit, int digits) {
  const Unit read = read_in(physical, unit, std::abs(value));
  return read.name == unit ? with_unit(value, unit, digits)
                           : format("{:.{}g} {}", value * read, digits, read.name);
}

FigureUnits units_of(const Physical& physical) {
  if (!physical) {
    return {};
  }
  const design::Scales& scales = physical->scales;
  const double speed = scales.velocity_m_per_s;
  const double energy = speed * speed * scales.mass_kg.value_or(1);
  if (physical->inches) {
    const auto read = [&](std::string_view unit, double scale) {
      const Unit now = read_in(physical, unit, scale);
      return Unit{scale * now, now.name};
    };
    const double inches = read("m/s", speed).factor;
    return {.length = read("m", scales.length_m),
            .time = {scales.time_s, "s"},
            .velocity = {inches, "in/s"},
            .energy = scales.mass_kg ? read("J", energy) : Unit{inches * inches, "in²/s²"},
            .force = scales.mass_kg ? read("N", *scales.friction_force_n(1)) : Unit{}};
  }
  return {.length =
              scales.length_m > 10 ? Unit{scales.length_m, "m"} : Unit{scales.length_m * 1e3, "mm"},
          .time = {scales.time_s, "s"},
          .velocity = {speed, "m/s"},
          .energy = scales.mass_kg ? in_joules(energy) : Unit{energy, "J/kg"},
          .force = scales.mass_kg ? in_newtons(*scales.friction_force_n(1)) : Unit{}};
}

Unit FigureUnits::of(Dimension dimension) const {
  return dimension == Dimension::length      ? length
         : dimension == Dimension::velocity  ? velocity
         : dimension == Dimension::gravities ? Unit{1, "g"}
                                             : Unit{};
}

std::string FigureUnits::place_words(double x) const {
  return x == 0 ? "0" : length.words(x);
}

std::string FigureUnits::time_words(double value) const {
  return (time.name.empty() ? "τ = " : "") + time.words(value);
}

}  // namespace stillpoint::report
