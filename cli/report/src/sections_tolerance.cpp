// SPDX-License-Identifier: MIT
// How far a damper may be off, in words. What it withstands is rounded down.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

namespace stillpoint::report {

namespace {

/// "+-8.63 %", "-10 to +20 %"; "exact" of what may not be off.
std::string off_by(double below, double above, int shown) {
  const std::string least = percent_digits(below, shown);
  const std::string most = percent_digits(above, shown);
  return below + above == 0 ? "exact"
         : least == most    ? "+-" + most
                            : format("-{} to +{}", least.substr(0, least.find(' ')), most);
}

std::string side(std::string_view name, double below, double above, int shown) {
  return below + above == 0 ? format("{} exact", name)
                            : format("{} of {}", off_by(below, above, shown), name);
}

}  // namespace

std::string percent_digits(double tolerance, int shown) {
  constexpr double as_large = 1e-8;  // of what is as large as was asked for, or as can be
  return limit_digits(100 * tolerance * (1 + as_large), false, shown) + " %";
}

bool leaves_any(double tolerance) {
  constexpr double none = 1e-6;  // the distance that a design keeps from an edge, and rounding
  return tolerance >= none;
}

std::string tolerance_text(const design::Limits& limits, double tolerance, int shown) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  return limits.shape == design::BoxShape{}
             ? percent_digits(tolerance, shown)
             : format("{} and {}", side("f", tolerance * f_low, tolerance * f_high, shown),
                      side("delta", tolerance * delta_low, tolerance * delta_high, shown));
}

std::string tolerance_head(const design::Limits& limits) {
  return limits.shape == design::BoxShape{} ? "tolerance" : "f, delta off by";
}

std::string tolerance_cell(const design::Limits& limits, const std::optional<double>& tolerance) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  constexpr int few = 3;  // a table has 80 columns
  const double r = tolerance.value_or(0);
  return !tolerance                           ? "none"
         : !leaves_any(r)                     ? "0 %"
         : limits.shape == design::BoxShape{} ? off_by(r, r, usual_digits)
                                              : format("{}, {}", off_by(r * f_low, r * f_high, few),
                                                       off_by(r * delta_low, r * delta_high, few));
}

std::string tolerance_words(const design::Limits& limits, double tolerance, double delta) {
  const bool notch = delta > 0;
  if (!leaves_any(tolerance)) {
    return format(
        "f{} must be exact: the damper is within a millionth of an edge of the admissible region",
        notch ? " or delta" : "");
  }
  const design::BoxShape& shape = limits.shape;
  if (!notch && shape.f_low + shape.f_high == 0) {
    return "f must be exact";
  }
  const bool both = shape.f_low + shape.f_high > 0 && shape.delta_low + shape.delta_high > 0;
  return !notch ? "f may be off by " + off_by(tolerance * limits.shape.f_low,
                                              tolerance * limits.shape.f_high, usual_digits)
         : limits.shape == design::BoxShape{}
             ? "f and delta may both be off by +-" + tolerance_text(limits, tolerance)
             : tolerance_text(limits, tolerance) + (both ? " at once" : "");
}

}  // namespace stillpoint::report
