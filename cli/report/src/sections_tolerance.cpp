// SPDX-License-Identifier: MIT
// How far a damper may be off, in words. What it withstands is rounded down.
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::report {

namespace {

constexpr double rounding = 1e-9;  // of what is as large as was asked for

/// One side of a box: "+-8.63 % of f", "0.8 to 1.2 times f"; empty if it may not be off.
std::string side(std::string_view name, double below, double above, int shown) {
  if (std::abs(below - above) <= rounding * above) {
    return above > 0 ? format("+-{} of {}", percent_digits(std::min(below, above), shown), name)
                     : "";
  }
  return format("{} to {} times {}", limit_digits((1 - below) * (1 - rounding), true, shown),
                limit_digits((1 + above) * (1 + rounding), false, shown), name);
}

}  // namespace

std::string percent_digits(double tolerance, int shown) {
  return limit_digits(100 * tolerance * (1 + rounding), false, shown) + " %";
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

std::string tolerance_words(const design::Limits& limits, double tolerance) {
  if (!leaves_any(tolerance)) {
    return "f and delta must be exact: the damper is on the edge of what is admissible";
  }
  return limits.shape == design::BoxShape{}
             ? format("f and delta may both be off by +-{}", percent_digits(tolerance))
             : box_text(limits, tolerance);
}

}  // namespace stillpoint::report
