// SPDX-License-Identifier: MIT
#pragma once

// What the searches of later arrivals and of ranges have in common: the variables of
// search_space.hpp.

#include <Eigen/Core>

namespace stillpoint::design {

/// x stays above it: at a = 0 the slopes of a half-cycle without any speed have no limit.
inline constexpr double least_x = 1e-12;

/// In (a, d, t) at (x, y, t), with the slopes as NLopt wants them.
struct Scaled {
  double a_cap;
  double d_cap;
  double tolerance;

  [[nodiscard]] double box(const Eigen::VectorXd& point) const {
    return point.size() == 3 ? point[2] : tolerance;
  }
  void slopes(Eigen::VectorXd& gradient, double by_a, double by_d, double by_t) const {
    const Eigen::Vector3d all(by_a * a_cap, by_d * d_cap, by_t);
    gradient = all.head(gradient.size()).eval();
  }
};

}  // namespace stillpoint::design
