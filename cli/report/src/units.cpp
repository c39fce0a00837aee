// SPDX-License-Identifier: MIT
#include "units.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>

#include <numbers>
#include <tuple>
#include <utility>

namespace stillpoint::report {

std::string with_blank(const std::string& unit) {
  return unit.empty() ? "" : " " + unit;
}

std::string length_shown(const Physical& physical, double length, std::optional<int> digits) {
  return physical && length != 0
             ? with_unit(length * physical->scales.length_m, "m", digits.value_or(5))
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
  constexpr int with_a_unit = 5;
  constexpr int plain = 6;
  constexpr double all_its_digits = 1e5;  // mm; beyond, metres
  if (!physical) {
    return limit_digits(length, upwards, digits.value_or(plain));
  }
  const FigureUnits units(physical);
  const double shown = length * units.length;
  const double metres = length * physical->scales.length_m;
  return shown < all_its_digits
             ? limit_digits(shown, upwards, digits.value_or(with_a_unit)) + " " + units.length_unit
             : limit_digits(metres, upwards, digits.value_or(with_a_unit)) + " m";
}

std::string figure_shown(const Physical& physical, Dimension dimension, double value) {
  constexpr double least_m = 1e-6;  // the least that a report tells from 0
  switch (dimension) {
    case Dimension::length:
      return physical && value > 0 && value * physical->scales.length_m < least_m
                 ? "less than " + with_unit(least_m, "m")
                 : length_shown(physical, value);
    case Dimension::time:
      return time_shown(physical, value);
    case Dimension::velocity:
      return FigureUnits(physical).velocity_words(value);
    case Dimension::gravities:
      return acceleration_shown(value);
    default:
      return format("{:.4g}", value);
  }
}

std::pair<std::string, std::string> told_apart(const Physical& physical, Dimension dimension,
                                               double value, double limit) {
  const auto [unit, name] = FigureUnits(physical).of(dimension);
  const auto shown = [factor = unit, after = with_blank(name)](double of, int digits) {
    return format("{:.{}g}{}", of * factor, digits, after);
  };
  std::pair usual{figure_shown(physical, dimension, value),
                  figure_shown(physical, dimension, limit)};
  if (value <= limit || usual.first != usual.second) {
    return usual;
  }
  const int digits =
      digits_until(6, [&](int now) { return shown(value, now) != shown(limit, now); });
  return {shown(value, digits), shown(limit, digits)};
}

std::string beyond(const Physical& physical, Dimension dimension, double value, double limit) {
  const auto [one, other] = told_apart(physical, dimension, value, limit);
  return format("{} where {} is allowed", one, other);
}

std::string in(const std::string& name, const std::string& unit) {
  return name + (unit.empty() ? "" : ", " + unit);
}

namespace {

/// In the unit in which it has digits before the point.
std::pair<double, std::string> in_joules(double energy) {
  return energy >= 1e3 ? std::pair(1e-3 * energy, "kJ")
         : energy >= 1 ? std::pair(energy, "J")
                       : std::pair(1e3 * energy, "mJ");
}

}  // namespace

FigureUnits::FigureUnits(const Physical& physical) {
  if (!physical) {
    return;
  }
  const design::Scales& scales = physical->scales;
  const bool large = scales.length_m > 10;
  length = scales.length_m * (large ? 1 : 1e3);
  time = scales.time_s;
  velocity = scales.velocity_m_per_s;
  energy = scales.velocity_m_per_s * scales.velocity_m_per_s * scales.mass_kg.value_or(1);
  length_unit = large ? "m" : "mm";
  time_unit = "s";
  velocity_unit = "m/s";
  energy_unit = "J/kg";
  if (scales.mass_kg) {
    std::tie(energy, energy_unit) = in_joules(energy);
  }
  delta_label += ", " + length_unit;
  x_label += ", " + length_unit;
  time_label = "time, s";
  velocity_label = "velocity, m/s";
  energy_label += ", " + energy_unit;
}

std::pair<double, std::string> FigureUnits::of(Dimension dimension) const {
  return dimension == Dimension::length      ? std::pair(length, length_unit)
         : dimension == Dimension::velocity  ? std::pair(velocity, velocity_unit)
         : dimension == Dimension::gravities ? std::pair(1.0, std::string("g"))
                                             : std::pair(1.0, std::string());
}

namespace {

std::string few_with_unit(double value, const std::string& unit) {
  return format("{}{}{}", few_digits(value + 0.0), unit.empty() ? "" : " ", unit);
}

}  // namespace

std::string FigureUnits::words(Dimension dimension, double value) const {
  const auto [unit, name] = of(dimension);
  return few_with_unit(value * unit, name);
}
std::string FigureUnits::length_words(double value) const {
  return few_with_unit(value * length, length_unit);
}
std::string FigureUnits::place_words(double x) const {
  return x == 0 ? "0" : length_words(x);
}
std::string FigureUnits::time_words(double value) const {
  return (time_unit.empty() ? "τ = " : "") + few_with_unit(value * time, time_unit);
}
std::string FigureUnits::velocity_words(double value) const {
  return few_with_unit(value * velocity, velocity_unit);
}
std::string FigureUnits::energy_words(double value) const {
  return few_with_unit(value * energy, energy_unit);
}

}  // namespace stillpoint::report
