// SPDX-License-Identifier: MIT
#include "figures/region_column.hpp"

#include "figures/report_figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace stillpoint::report {

RegionColumn region_column(const design::Problem& problem, double f) {
  RegionColumn column{f, design::least_stopping_delta(problem, f), {}};
  const std::int64_t last = std::min(problem.arrivals, most_drawn_strips + 1);
  for (std::int64_t n = 0; n <= last; ++n) {
    // Every hit up to V0 needs the first arrival.
    const bool exists = n == 0 ? problem.residual.has_value() : n == 1 || problem.v0_low != 0.0;
    auto range = exists ? design::delta_range(problem, n, f) : std::nullopt;
    if (range && n > most_drawn_strips) {
      range->low = column.stop;
    }
    column.strips.push_back(range);
  }
  return column;
}

namespace {

bool has_same_strips(const RegionColumn& a, const RegionColumn& b) {
  return std::ranges::equal(
      a.strips, b.strips, {}, [](const auto& strip) { return strip.has_value(); },
      [](const auto& strip) { return strip.has_value(); });
}

}  // namespace

std::vector<RegionColumn> region_columns(const design::Problem& problem,
                                         const std::vector<double>& at) {
  std::vector<RegionColumn> columns;
  columns.reserve(at.size());
  for (const double f : at) {
    RegionColumn next = region_column(problem, f);
    while (!columns.empty() && !has_same_strips(columns.back(), next)) {
      const RegionColumn last = columns.back();
      const double edge = last_inside(last.f, f, [&](double middle) {
        return has_same_strips(last, region_column(problem, middle));
      });
      const double beyond = std::min(f, edge + (f - last.f) * 1e-9);
      columns.push_back(region_column(problem, edge));
      columns.push_back(region_column(problem, beyond));
      if (beyond == f) {
        break;
      }
    }
    columns.push_back(std::move(next));
  }
  return columns;
}

std::optional<Interval> below_strip(const RegionColumn& column, std::size_t n) {
  const auto& strips = column.strips;
  // Strip 1 begins at the start, so that nothing is above it.
  if (strips[0] || (n == 0 ? strips[1].has_value() : !strips[n])) {
    return std::nullopt;
  }
  Interval range{column.stop, n == 0 ? HUGE_VAL : strips[n]->low};
  for (std::size_t below = n + 1; below < strips.size(); ++below) {
    if (strips[below]) {
      range.low = std::max(range.low, strips[below]->high);
    }
  }
  return range;
}

}  // namespace stillpoint::report
