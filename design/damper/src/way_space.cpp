// SPDX-License-Identifier: MIT
#include "way_space.hpp"

#include "rest.hpp"
#include "scaled_point.hpp"
#include "search_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stillpoint::design {

namespace {

/// t stays below 1, as in search_space.cpp.
constexpr double almost_all = 1 - 1e-6;

std::vector<Function> conditions_of(const Way& way, const Scaled& scale) {
  const BoxShape shape = way.limits.shape;
  std::vector<Function> list;
  if (way.a2 > 0) {
    list.emplace_back([=, a2 = way.a2](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
      const double low = 1 - shape.f_low * scale.box(at);
      scale.slopes(gradient, -low / scale.a_cap, 0, at[0] * shape.f_low);
      return a2 / scale.a_cap - at[0] * low;
    });
  }
  list.emplace_back([=](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    const double high = 1 + shape.f_high * scale.box(at);
    scale.slopes(gradient, high / scale.a_cap, 0, at[0] * shape.f_high);
    return at[0] * high - 1;
  });
  list.emplace_back([=](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    const double high = 1 + shape.delta_high * scale.box(at);
    scale.slopes(gradient, 0, high / scale.d_cap, at[1] * shape.delta_high);
    return at[1] * high - 1;
  });
  // A corner of the box: each side goes outwards, +1, or inwards, -1.
  const auto edge = [&](double outwards_f, double outwards_d, double sign, const auto& value) {
    const double f_part = outwards_f * (outwards_f > 0 ? shape.f_high : shape.f_low);
    const double d_part = outwards_d * (outwards_d > 0 ? shape.delta_high : shape.delta_low);
    list.emplace_back([=](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
      const double t = scale.box(at);
      const double a = at[0] * scale.a_cap;
      const double d = at[1] * scale.d_cap;
      const double f_corner = 1 + f_part * t;
      const double d_corner = 1 + d_part * t;
      const unit::EdgeSpeed now = value(a * f_corner, d * d_corner);
      scale.slopes(gradient, sign * f_corner * now.by_a, sign * d_corner * now.by_d,
                   sign * (f_part * a * now.by_a + d_part * d * now.by_d));
      return sign * now.square;
    });
  };
  const auto less = [](unit::EdgeSpeed speed, double square) {
    speed.square -= square;
    return speed;
  };
  if (way.n > 0 && way.v_low > 0) {
    edge(1, 1, 1,
         [=](double a, double d) { return less(reach_edge(way, a, d), way.v_low * way.v_low); });
  } else if (way.n > 0) {
    edge(1, -1, 1, [=](double a, double d) {
      const unit::EdgeSpeed notch = returning_notch(way, a);
      return unit::EdgeSpeed{notch.square - 2 * d, notch.by_a, -2};
    });
  }
  if (way.n == 0 || !way.stops_early() || way.q > 0) {
    edge(-1, -1, -1, [=](double a, double d) { return less(last_edge(way, a, d), 1); });
  }
  if (way.stops_early()) {
    edge(-1, -1, -1, [=](double a, double d) { return less(stop_edge(way, a, d), 1); });
  }
  return list;
}

/// Over pi. The motion of the largest peak may end in any way within the residual, so the slopes
/// are taken as differences.
double half_turns(const Way& way, double a, double d) {
  return unit::rest(a, d, way.passages()).phase / std::numbers::pi;
}

double cost_at(const Way& way, Objective objective, double a, double d) {
  return objective == Objective::time ? half_turns(way, a, d) : objective_value(objective, a);
}

}  // namespace

double way_cost(const Way& way, Objective objective, const DesignPoint& point) {
  return objective == Objective::robust
             ? -point.tolerance
             : cost_at(way, objective, way.scaled(point.f), point.delta / way.square());
}

NloptProblem way_posed(ConstraintSupport support, const Way& way, Objective objective,
                       const DesignPoint& start, Tried& tried) {
  const Scaled scale{way.a_cap, way.d_cap, way.limits.tolerance};
  const bool robust = objective == Objective::robust;
  const bool by_box = robust && support == ConstraintSupport::yes;
  const Eigen::Vector3d from(way.scaled(start.f) / scale.a_cap,
                             start.delta / way.square() / scale.d_cap, scale.tolerance);
  const Eigen::Index size = by_box ? 3 : 2;
  NloptProblem posed;
  posed.lower = Eigen::Vector3d(least_x, 0, scale.tolerance).head(size);
  posed.upper = Eigen::Vector3d(1, 1, std::max(almost_all, scale.tolerance)).head(size);
  posed.start = from.head(size);
  const auto cost = [&way, &tried, scale, objective](const Eigen::VectorXd& at,
                                                     Eigen::VectorXd& gradient) {
    const double a = at[0] * scale.a_cap;
    const double d = at[1] * scale.d_cap;
    tried.x.push_back(at[0]);
    if (objective != Objective::time) {
      scale.slopes(gradient, objective_slope(objective, a), 0, 0);
    } else if (gradient.size() > 0) {
      constexpr double step = 1e-6;
      const auto slope = [&](double by_a, double by_d) {
        return (half_turns(way, a + by_a, d + by_d) - half_turns(way, a - by_a, d - by_d)) /
               (2 * (by_a + by_d));
      };
      scale.slopes(gradient, slope(step * a, 0), d > 0 ? slope(0, step * d) : 0, 0);
    }
    return cost_at(way, objective, a, d);
  };
  const auto conditions = conditions_of(way, scale);
  if (support == ConstraintSupport::yes) {
    posed.constraints = conditions;
    posed.objective = cost;
    if (by_box) {
      posed.objective = [&tried, scale](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
        tried.x.push_back(at[0]);
        scale.slopes(gradient, 0, 0, -1);
        return -at[2];
      };
    }
    return posed;
  }
  posed.objective = [&way, &tried, scale, robust, cost, conditions](const Eigen::VectorXd& at,
                                                                    Eigen::VectorXd& /*gradient*/) {
    // Above every value inside: a half-cycle takes pi.
    const double above_all = 10.0 + way.passages();
    Eigen::VectorXd none;
    double violation = 0;
    for (const Function& condition : conditions) {
      violation = std::max(violation, condition(at, none));
    }
    double value = above_all + violation;
    if (!(violation > 0)) {
      value = robust ? -largest_tolerance(way, way.f_of(at[0] * scale.a_cap),
                                          at[1] * scale.d_cap * way.square())
                            .value_or(0)
                     : cost(at, none);
    }
    if (value < tried.value) {
      tried.value = value;
      tried.best = at.head<2>();
    }
    return value;
  };
  return posed;
}

}  // namespace stillpoint::design
