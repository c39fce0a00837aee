// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace stillpoint::report {

using figures::axis_around;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// More than a figure is wide.
constexpr std::size_t most_columns = 1000;

/// W at the instants that show it.
struct Wave {
  double horizon;

  std::vector<FigurePoint> operator()(const NoExcitation& /*none*/) const {
    return {{0, 0}, {horizon, 0}};
  }
  template <class Law>
  std::vector<FigurePoint> operator()(const Law& law) const {
    const double last = std::min(duration(law).value_or(horizon), horizon);
    const std::int64_t count = IsLine<Law> ? 1 : sample_count(law.lambda, last);
    std::vector<FigurePoint> points;
    for (std::int64_t i = 0; i <= count; ++i) {
      const double tau = last * static_cast<double>(i) / static_cast<double>(count);
      points.push_back({tau, load_at(law, tau)});
    }
    return until_horizon(std::move(points));
  }
  std::vector<FigurePoint> operator()(const Record& record) const {
    std::vector<FigurePoint> points;
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      points.push_back(
          {record.times.empty() ? static_cast<double>(i) * record.step : record.times[i],
           record.values[i]});
    }
    return until_horizon(std::move(points));
  }

 private:
  /// Up to the horizon, and 0 from its own end on.
  [[nodiscard]] std::vector<FigurePoint> until_horizon(std::vector<FigurePoint> points) const {
    const auto beyond =
        std::ranges::find_if(points, [this](const FigurePoint& at) { return at.x > horizon; });
    if (beyond != points.end()) {
      if (beyond != points.begin()) {
        const FigurePoint& before = *std::prev(beyond);
        const double part = (horizon - before.x) / (beyond->x - before.x);
        *beyond = {horizon, before.y + (beyond->y - before.y) * part};
        points.erase(std::next(beyond), points.end());
        return points;
      }
      points.clear();  // a record that begins later
    }
    if (points.empty() || points.back().x < horizon) {
      const double since = points.empty() ? 0 : points.back().x;
      points.push_back({since, 0});
      points.push_back({horizon, 0});
    }
    return points;
  }
};

/// The least and the largest of each column if there are more points than columns.
std::vector<FigurePoint> thinned(const std::vector<FigurePoint>& points) {
  if (points.size() <= 2 * most_columns) {
    return points;
  }
  std::vector<FigurePoint> kept;
  const std::size_t step = (points.size() + most_columns - 1) / most_columns;
  for (std::size_t first = 0; first < points.size(); first += step) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end =
        points.begin() + static_cast<std::ptrdiff_t>(std::min(first + step, points.size()));
    auto [least, most] = std::ranges::minmax_element(begin, end, {}, &FigurePoint::y);
    if (most < least) {
      std::swap(least, most);
    }
    kept.push_back(*least);
    if (most != least) {
      kept.push_back(*most);
    }
  }
  return kept;
}

}  // namespace

Figure excitation_figure(const Excitation& excitation, const DrawnMotion& motion,
                         const FigureUnits& units) {
  std::vector<FigurePoint> points = thinned(std::visit(Wave{motion.shown_to}, excitation));
  double least = 0;
  double most = 0;
  for (FigurePoint& at : points) {
    at.x *= units.time;
    least = std::min(least, at.y);
    most = std::max(most, at.y);
  }
  Figure figure;
  figure.id = "excitation";
  figure.title = "Excitation" + beginning(motion);
  figure.x = {units.time_label, 0, motion.shown_to * units.time};
  figure.height = 130;
  figure.below = true;
  figure.y = axis_around("base acceleration W, g", least, most);
  figure.description =
      fmt::format("Acceleration of the base over time, from {:.4g} g to {:.4g} g.", least, most);
  add_lock(figure, motion, units);
  figure.curves.push_back({"", {std::move(points)}, Ink::purple});
  return figure;
}

}  // namespace stillpoint::report
