// SPDX-License-Identifier: MIT
#include "figures/lines.hpp"
#include "figures/motion_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stillpoint::report {

using figures::axis_around;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// W at the instants that show it, up to its end.
std::vector<FigurePoint> points_of(const NoExcitation& /*none*/, double /*horizon*/) {
  return {};
}
template <class Law>
std::vector<FigurePoint> points_of(const Law& law, double horizon) {
  const double last = std::min(duration(law).value_or(horizon), horizon);
  const std::int64_t count = IsLine<Law> ? 1 : design::sample_count(law.lambda, last);
  std::vector<FigurePoint> points;
  for (std::int64_t i = 0; i <= count; ++i) {
    const double tau = last * static_cast<double>(i) / static_cast<double>(count);
    points.push_back({tau, load_at(law, tau)});
  }
  return points;
}
std::vector<FigurePoint> points_of(const Record& record, double horizon) {
  std::vector<FigurePoint> points;
  for (std::size_t i = 0; i < record.values.size(); ++i) {
    const double tau =
        record.times.empty() ? static_cast<double>(i) * record.step : record.times[i];
    if (tau > horizon) {
      if (!points.empty()) {
        const FigurePoint& before = points.back();
        points.push_back({horizon, std::lerp(before.y, record.values[i],
                                             (horizon - before.x) / (tau - before.x))});
      }
      break;
    }
    points.push_back({tau, record.values[i]});
  }
  return points;
}

/// W from 0 to the horizon, 0 from its own end on.
std::vector<FigurePoint> wave(const Excitation& excitation, double horizon) {
  auto points =
      std::visit([horizon](const auto& law) { return points_of(law, horizon); }, excitation);
  if (points.empty() || points.back().x < horizon) {
    points.push_back({points.empty() ? 0 : points.back().x, 0});
    points.push_back({horizon, 0});
  }
  return points;
}

}  // namespace

Figure excitation_figure(const Excitation& excitation, const DrawnMotion& motion,
                         const FigureUnits& units) {
  std::vector<FigurePoint> points = thinned(wave(excitation, motion.shown_to));
  for (FigurePoint& at : points) {
    at.x *= units.time.factor;
  }
  const auto [least, most] = extent(points, &FigurePoint::y);
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
