// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace stillpoint::design {

/// New points of the unit box from the best of those that were tried. On a thin curved ridge
/// between limits, where neither a grid nor a descent makes progress, their differences point along
/// the ridge.
class SuiteOffspring {
 public:
  using Point = std::vector<double>;

  /// Each population is different.
  explicit SuiteOffspring(std::uint64_t population) : random_(20'081 + population) {}

  /// Around the best of them.
  [[nodiscard]] std::vector<Point> about(const Point& best, std::size_t count);
  /// From differences of two of `kept` added to a third, and around each of them.
  [[nodiscard]] std::vector<Point> of(const std::vector<Point>& kept, std::size_t count);

 private:
  double unit();  ///< in [0, 1). The library's distributions differ between implementations
  const Point& any(const std::vector<Point>& kept);
  Point near(Point point);

  std::mt19937_64 random_;
};

}  // namespace stillpoint::design
