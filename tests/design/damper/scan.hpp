// SPDX-License-Identifier: MIT
#pragma once

// The best design of all points of a grid: slow, but simple. In long
// double and in the paper's own units, so that it shares no formula with the search.

#include <stillpoint/design.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillpoint::design_test {

class Scan {
 public:
  using Wide = long double;
  static constexpr int delta_steps = 100;

  Scan(const design::Problem& problem, const design::Limits& limits)
      : v0_(problem.v0),
        p_(problem.p),
        f2_((v0_ * v0_ - Wide(problem.beta) * p_ * problem.beta * p_) / (2 * Wide(problem.beta))),
        f_cap_(v0_ * p_ / std::sqrt(Wide(8))),
        delta_cap_(v0_ * v0_ / 2),
        criterion_(problem.criterion),
        asked_(limits.tolerance) {
    if (limits.f_max) {
      f_cap_ = std::min<Wide>(f_cap_, *limits.f_max);
    }
    if (limits.delta_max) {
      delta_cap_ = std::min<Wide>(delta_cap_, *limits.delta_max);
    }
  }

  [[nodiscard]] Wide delta1(Wide f) const {
    const Wide s = radius(f);
    return criterion_ == design::Criterion::published ? (s - 2 * f) * (s - 2 * f) / (2 * p_ * p_)
                                                      : (s - f) * (s - 3 * f) / (2 * p_ * p_);
  }

  /// The largest R of a point, by bisection; negative outside of the region. One below `least` need
  /// not be found: any number below `least` stands for it.
  [[nodiscard]] Wide tolerance(Wide f, Wide delta, Wide least = 0) const {
    const Wide linear =
        std::min({f2_ > 0 ? 1 - f2_ / f : Wide(1), f_cap_ / f - 1, delta_cap_ / delta - 1});
    const auto stops = [&](Wide r) { return delta * (1 - r) > delta1(f * (1 - r)); };
    if (!stops(least)) {
      return -1;
    }
    if (linear < least) {
      return linear;
    }
    Wide low = least;
    Wide high = 1;
    while (high - low > 1e-18L) {
      const Wide middle = (low + high) / 2;
      (stops(middle) ? low : high) = middle;
    }
    return std::min(linear, low);
  }

  /// The largest tolerance of any Delta for f, or `best` if that is larger.
  [[nodiscard]] Wide best_tolerance(Wide f, int steps, Wide best = -1) const {
    const Wide floor = std::max<Wide>(delta1(f), 0);
    for (int i = 1; i <= steps; ++i) {
      const Wide delta = floor + (delta_cap_ - floor) * i / steps;
      best = std::max(best, tolerance(f, delta, std::max<Wide>(best, 0)));
    }
    return best;
  }

  /// Whether some Delta is admissible with f at the requested tolerance.
  [[nodiscard]] bool serves(Wide f) const {
    const Wide lowest = std::max<Wide>(delta1(f * (1 - asked_)), 0) / (1 - asked_);
    return f * (1 - asked_) >= f2_ && f * (1 + asked_) <= f_cap_ &&
           lowest < delta_cap_ / (1 + asked_);
  }

  /// What the objective minimises.
  [[nodiscard]] Wide cost(design::Objective objective, Wide f) const {
    const Wide s = radius(f);
    switch (objective) {
      case design::Objective::robust:
        return -best_tolerance(f, delta_steps);
      case design::Objective::amplitude:
        return (s - f) / (p_ * p_);
      case design::Objective::time:
        return (std::atan2(v0_ * p_, f) + std::acos(std::max<Wide>(-1, -f / (s - 2 * f)))) / p_;
      case design::Objective::acceleration:
        return s;
    }
    return 0;
  }

  /// The least cost of all feasible f of the grid (for `robust`, the cost itself says whether f is
  /// feasible); HUGE_VAL if none is.
  [[nodiscard]] Wide least_cost(design::Objective objective) const {
    if (objective == design::Objective::robust) {
      Wide best = -1;
      for (const Wide f : grid(100)) {
        best = best_tolerance(f, delta_steps, best);
      }
      return -best;
    }
    Wide best = HUGE_VAL;
    for (const Wide f : grid(1000)) {
      if (serves(f)) {
        best = std::min(best, cost(objective, f));
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Wide radius(Wide f) const { return std::sqrt(f * f + v0_ * p_ * v0_ * p_); }

  /// Evenly over the interval of f, and towards both of its ends by factors.
  [[nodiscard]] std::vector<Wide> grid(int steps) const {
    const Wide low = std::max<Wide>(f2_, 0);
    const Wide width = f_cap_ - low;
    std::vector<Wide> list;
    for (int i = 0; i <= steps; ++i) {
      const Wide part = Wide(i) / steps;
      list.push_back(low + width * part);
      const Wide near = width * std::pow(Wide(10), -12 * part);
      list.push_back(low + near);
      list.push_back(f_cap_ - near);
    }
    return list;
  }

  Wide v0_;
  Wide p_;
  Wide f2_;
  Wide f_cap_;
  Wide delta_cap_;
  design::Criterion criterion_;
  Wide asked_;
};

}  // namespace stillpoint::design_test
