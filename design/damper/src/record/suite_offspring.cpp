// SPDX-License-Identifier: MIT
#include "record/suite_offspring.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

namespace {

/// All step lengths are equally likely, from an eighth of the box down to a thousandth of that.
constexpr int longest = -3;
constexpr int lengths = 10;
/// The share of points that stay near one; the others are differences.
constexpr double near_share = 0.3;
/// A difference is taken 1/16 to 4 times, each doubling as likely: a population that only shortens
/// them collapses before it reaches the end of its ridge.
constexpr int least_factor = -4;
constexpr int factors = 6;

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
    const double factor = std::ldexp(1 + unit(), least_factor + static_cast<int>(unit() * factors));
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
