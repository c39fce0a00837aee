// SPDX-License-Identifier: MIT
// How far a damper may be off, in words. What it withstands is rounded down.
#include "sections.hpp"

#include <stillpoint/design/tolerance.hpp>

namespace stillpoint::report {

namespace {

std::string off_by(std::string_view name, double below, double above, int shown,
                   std::string_view sign = "+-") {
  const std::string least = percent_digits(below, shown);
  const std::string most = percent_digits(above, shown);
  return below + above == 0 ? format("{} exact", name)
         : least == most    ? format("{} {}{}", name, sign, most)
                            : format("{} -{} to +{}", name, least.substr(0, least.find(' ')), most);
}

}  // namespace

std::string percent_digits(double tolerance, int shown) {
  constexpr double as_large = 1e-8;  // of what is as large as was asked for, or as can be
  return limit_digits(100 * tolerance * (1 + as_large), false, shown) + " %";
}

bool leaves_any(double tolerance) {
  return tolerance >= design::least_tolerance;
}

std::string sides_text(const design::BoxShape& shape, double tolerance, int shown,
                       std::string_view delta, std::string_view sign) {
  return format(
      "{}, {}", off_by("f", tolerance * shape.f_low, tolerance * shape.f_high, shown, sign),
      off_by(delta, tolerance * shape.delta_low, tolerance * shape.delta_high, shown, sign));
}

std::string tolerance_text(const design::Limits& limits, double tolerance, int shown) {
  return limits.shape == design::BoxShape{} ? percent_digits(tolerance, shown)
                                            : sides_text(limits.shape, tolerance, shown);
}

std::string tolerance_cell(const design::Limits& limits, const std::optional<double>& tolerance) {
  constexpr int few = 2;  // a table has 80 columns
  return !tolerance                           ? "none"
         : !leaves_any(*tolerance)            ? "0 %"
         : limits.shape == design::BoxShape{} ? "+-" + percent_digits(*tolerance)
                                              : tolerance_text(limits, *tolerance, few);
}

void add_buildable(Section& answer, const Physical& physical, const Interval& f,
                   const Interval& delta) {
  if (!physical || !physical->scales.mass_kg || !(f.low < f.high || delta.low < delta.high)) {
    return;
  }
  // In the unit in which the largest has one to three digits before the point.
  const auto words = [&](std::string_view what, const Interval& of, double si,
                         std::string_view unit) -> std::string {
    const double most = of.high * si;
    if (!(of.low < of.high)) {
      return most == 0 ? "" : format("{} {}", what, si_words(physical, most, unit, usual_digits));
    }
    Unit read = read_in(physical, unit, most);
    if (read.name == unit) {
      const auto [factor, sign] = most >= 1e6   ? std::pair(1e-6, "M")
                                  : most >= 1e3 ? std::pair(1e-3, "k")
                                  : most >= 1   ? std::pair(1.0, "")
                                                : std::pair(1e3, "m");
      read = {factor, format("{}{}", sign, unit)};
    }
    return format("{} {} {}", what, interval_digits(of.low * si * read, most * read), read.name);
  };
  const design::Scales& scales = physical->scales;
  const std::string friction = words("friction", f, *scales.friction_force_n(1), "N");
  const std::string notch = words("notch", delta, *scales.energy_per_passage_j(1), "J");
  answer.row("may be built", friction + (friction.empty() || notch.empty() ? "" : ", ") + notch);
}

void add_buildable(Section& answer, const Physical& physical, const design::DesignPoint& damper,
                   const design::Limits& limits) {
  const design::DesignPoint allowed = design::granted(damper, limits);
  if (leaves_any(allowed.tolerance)) {
    const design::DamperBox box = box_about(allowed, limits.shape);
    add_buildable(answer, physical, box.f, box.delta);
  }
}

std::string tolerance_words(const design::Limits& limits, double tolerance, double delta) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  const bool notch = delta > 0;
  return !leaves_any(tolerance)
             ? format(
                   "{} must be exact: the damper is within a millionth of an edge of the "
                   "admissible region",
                   notch ? "f or delta" : "f")
         : limits.shape == design::BoxShape{}
             ? format("{} be off by +-{}", notch ? "f and delta may both" : "f may",
                      percent_digits(tolerance))
         : notch ? tolerance_text(limits, tolerance) +
                       (f_low + f_high > 0 && delta_low + delta_high > 0 ? " at once" : "")
                 : off_by("f", tolerance * f_low, tolerance * f_high, usual_digits);
}

}  // namespace stillpoint::report
