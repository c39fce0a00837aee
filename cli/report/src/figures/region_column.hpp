// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/strips.hpp>
#include <stillpoint/figures/figure.hpp>

#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace stillpoint::report {

/// How Delta decides at one f that the peak allows and with which the mass can come back.
struct RegionColumn {
  double f;
  double stop;  ///< below it the mass passes the last arrival allowed
  /// The strips by arrival, from 0, any rest within the residual. Those of arrivals beyond the ones
  /// that are drawn are one.
  std::vector<std::optional<Interval>> strips;
};

[[nodiscard]] RegionColumn region_column(const design::Problem& problem, double f);

/// The f closest to `outside` at which something still holds that holds at `inside`.
template <class Holds>
double last_inside(double inside, double outside, const Holds& holds) {
  constexpr int halvings = 40;  // far below a pixel
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(inside, outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// The polygon of the ranges of Delta over f, times a unit, of those f that have one.
template <class RangeOf>
std::vector<figures::FigurePoint> outline_over(const Interval& f, double unit,
                                               const RangeOf& range_of) {
  constexpr int parts = 200;
  std::vector<figures::FigurePoint> lower;
  std::vector<figures::FigurePoint> upper;
  const auto has = [&](double at) { return range_of(at).has_value(); };
  const auto add = [&](double at, const std::optional<Interval>& range) {
    lower.push_back({at, range->low * unit});
    upper.push_back({at, range->high * unit});
  };
  double last = f.low;
  bool had = false;
  for (int i = 0; f.low <= f.high && i <= parts; ++i) {
    const double at = f.low + (f.high - f.low) * i / parts;
    const std::optional<Interval> range = range_of(at);
    if (i > 0 && had != range.has_value()) {  // it begins or ends between them
      const double edge = had ? last_inside(last, at, has) : last_inside(at, last, has);
      add(edge, range_of(edge));
    }
    if (range) {
      add(at, range);
    }
    had = range.has_value();
    last = at;
  }
  if (lower.size() < 2) {
    return {};
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

/// Columns at these f, in rising order, and on both sides of each f between them where a strip
/// begins or ends.
[[nodiscard]] std::vector<RegionColumn> region_columns(const design::Problem& problem,
                                                       const std::vector<double>& at);

/// Where the mass rests off centre or beyond the residual: from the next lower strip, or the stop,
/// to that of arrival n; n = 0: up to the start. Empty if there is no such strip or nothing
/// between.
[[nodiscard]] std::optional<Interval> below_strip(const RegionColumn& column, std::size_t n);

}  // namespace stillpoint::report
