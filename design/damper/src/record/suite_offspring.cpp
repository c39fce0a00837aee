// SPDX-License-Identifier: MIT
#include "record/suite_offspring.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

namespace {

/// Steps of all lengths are as likely, from an eighth of the box down to a thousandth of that.
constexpr int longest = -3;
constexpr int lengths = 10;
/// Of the points that stay near one; the others are differences, shortened to lengthened.
constexpr double near_share = 0.3;
constexpr double shortest_factor = 0.3;
constexpr double longest_factor = 1.2;

}  // namespace

std::vector<SuiteOffspring::Point> SuiteOffspring::about(const Point& best, std::size_t count) {
  std::vector<Point> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(near(best));
  }
  return points;
}

std::vector<SuiteOffspring::Point> SuiteOffspring::of(const std::vector<Point>& kept,
                                                      std::size_t count) {
  std::vector<Point> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool stays_near = unit() < near_share;
    Point point = any(kept);
    if (stays_near) {
      points.push_back(near(std::move(point)));
      continue;
    }
    const Point& to = any(kept);
    const Point& from = any(kept);
    const double factor = shortest_factor + (longest_factor - shortest_factor) * unit();
    for (std::size_t k = 0; k < point.size(); ++k) {
      point[k] = std::clamp(point[k] + factor * (to[k] - from[k]), 0.0, 1.0);
    }
    points.push_back(std::move(point));
  }
  return points;
}

double SuiteOffspring::unit() {
  return std::ldexp(static_cast<double>(random_() >> 11U), -53);
}

const SuiteOffspring::Point& SuiteOffspring::any(const std::vector<Point>& kept) {
  return kept[static_cast<std::size_t>(unit() * static_cast<double>(kept.size()))];
}

SuiteOffspring::Point SuiteOffspring::near(Point point) {
  const double reach = std::ldexp(1.0, longest - static_cast<int>(unit() * lengths));
  for (double& x : point) {
    x = std::clamp(x + reach * (2 * unit() - 1), 0.0, 1.0);
  }
  return point;
}

}  // namespace stillpoint::design
