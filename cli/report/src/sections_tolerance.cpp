// SPDX-License-Identifier: MIT
// How far a damper may be off, in words. What it withstands is rounded down.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

namespace {

constexpr double as_large = 1e-8;  // of what is as large as was asked for, or as can be

/// One side of a box: "+-8.63 % of f", "0.8 to 1.2 times f"; empty if it may not be off.
std::string side(std::string_view name, double below, double above, int shown) {
  if (std::abs(below - above) <= as_large * above) {
    return above > 0 ? format("+-{} of {}", percent_digits(std::min(below, above), shown), name)
                     : "";
  }
  return format("{} to {} times {}", limit_digits((1 - below) * (1 - as_large), true, shown),
                limit_digits((1 + above) * (1 + as_large), false, shown), name);
}

/// "+-8.63 %", or "-20 +8.63 %"; "none" without a tolerance.
std::string cell(const std::optional<double>& tolerance, double below, double above, int shown) {
  if (!tolerance || !leaves_any(*tolerance * std::max(below, above))) {
    return !tolerance ? "none" : below + above == 0 ? "not asked for" : "0 %";
  }
  const std::string least = percent_digits(*tolerance * below, shown);
  const std::string most = percent_digits(*tolerance * above, shown);
  return least == most ? "+-" + most : format("-{} +{}", least.substr(0, least.find(' ')), most);
}

}  // namespace

std::string tolerance_head(const design::Limits& limits) {
  return limits.shape == design::BoxShape{} ? "tolerance" : "f, delta off by";
}

std::string tolerance_cell(const design::Limits& limits, const std::optional<double>& tolerance) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  constexpr int shown = 3;  // a table has 80 columns
  return limits.shape == design::BoxShape{}
             ? cell(tolerance, f_low, f_high, usual_digits)
             : format("{}, {}", cell(tolerance, f_low, f_high, shown),
                      cell(tolerance, delta_low, delta_high, shown));
}

std::string percent_digits(double tolerance, int shown) {
  return limit_digits(100 * tolerance * (1 + as_large), false, shown) + " %";
}

bool leaves_any(double tolerance) {
  constexpr double none = 1e-6;  // the distance that a design keeps from an edge, and rounding
  return tolerance >= none;
}

std::string box_text(const design::Limits& limits, double tolerance, int shown) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  if (limits.shape == design::BoxShape{}) {
    return format("+-{} of f and delta at once", percent_digits(tolerance, shown));
  }
  const std::string of_f = side("f", tolerance * f_low, tolerance * f_high, shown);
  const std::string of_delta = side("delta", tolerance * delta_low, tolerance * delta_high, shown);
  return of_f.empty()       ? of_delta
         : of_delta.empty() ? of_f
                            : format("{} and {} at once", of_f, of_delta);
}

std::string tolerance_shown(const design::Limits& limits, double tolerance, int shown) {
  return "a tolerance of " + (limits.shape == design::BoxShape{}
                                  ? percent_digits(tolerance, shown)
                                  : box_text(limits, tolerance, shown));
}

std::string tolerance_words(const design::Limits& limits, double tolerance, double delta) {
  const bool notch = delta > 0;
  if (!leaves_any(tolerance)) {
    return format(
        "f{} must be exact: the damper is within a millionth of an edge of the admissible region",
        notch ? " or delta" : "");
  }
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  if (!notch) {
    return "f may be off by " + cell(tolerance, f_low, f_high, usual_digits);
  }
  return limits.shape == design::BoxShape{}
             ? format("f and delta may both be off by +-{}", percent_digits(tolerance))
             : box_text(limits, tolerance) + (f_low + f_high == 0 ? ", with f exactly as given"
                                              : delta_low + delta_high == 0
                                                  ? ", with delta exactly as given"
                                                  : "");
}

}  // namespace stillpoint::report
