// SPDX-License-Identifier: MIT
#include "way/space.hpp"

#include "search/objectives.hpp"
#include "unit_problem.hpp"
#include "way/room.hpp"
#include "way/unit_strip.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace stillpoint::design {

namespace {

/// t stays below 1, where the box would reach 0 and with it the end of every formula's range.
constexpr double almost_all = 1 - 1e-6;
/// x stays above it: at a = 0 the slopes of a half-cycle without any speed have no limit.
constexpr double least_x = 1e-12;

/// In (a, d, t) at (x, y, t), with the gradients in NLopt's form.
struct Scaled {
  double a_cap;
  double d_cap;
  double tolerance;

  [[nodiscard]] double box(const Eigen::VectorXd& point) const {
    return point.size() == 3 ? point[2] : tolerance;
  }
  void slopes(Eigen::VectorXd& gradient, double by_a, double by_d, double by_t) const {
    scaled_slopes(gradient, by_a * a_cap, by_d * d_cap, by_t);
  }
  static void scaled_slopes(Eigen::VectorXd& gradient, double by_x, double by_y, double by_t) {
    const Eigen::Vector3d all(by_x, by_y, by_t);
    gradient = all.head(gradient.size());
  }
};

unit::EdgeSpeed less(unit::EdgeSpeed speed, double square) {
  speed.square -= square;
  return speed;
}

/// A side of x (0) or y (1), `outwards` = +1 or -1, is not beyond `limit`.
Function side_of(const Scaled& scale, int which, double outwards, double part, double limit) {
  return [=](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    const double side = 1 + outwards * part * scale.box(at);
    const double along = outwards * side;
    Scaled::scaled_slopes(gradient, which == 0 ? along : 0, which == 1 ? along : 0,
                          at[which] * part);
    return outwards * (at[which] * side - limit);
  };
}

/// At a corner of the box: each side goes outwards, +1, or inwards, -1.
template <class Value>
Function edge_of(const Scaled& scale, const BoxShape& shape, double outwards_f, double outwards_d,
                 double sign, const Value& value) {
  const double f_part = outwards_f * (outwards_f > 0 ? shape.f_high : shape.f_low);
  const double d_part = outwards_d * (outwards_d > 0 ? shape.delta_high : shape.delta_low);
  return [=](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    const double t = scale.box(at);
    const double a = at[0] * scale.a_cap;
    const double d = at[1] * scale.d_cap;
    const double f_corner = 1 + f_part * t;
    const double d_corner = 1 + d_part * t;
    const unit::EdgeSpeed now = value(a * f_corner, d * d_corner);
    scale.slopes(gradient, sign * f_corner * now.by_a, sign * d_corner * now.by_d,
                 sign * (f_part * a * now.by_a + d_part * d * now.by_d));
    return sign * now.square;
  };
}

/// The inequalities of space.hpp, each <= 0 inside.
std::vector<Function> conditions_of(const Way& way, const Scaled& scale) {
  const BoxShape& shape = way.limits.shape;
  std::vector<Function> list;
  const auto add = [&](double outwards_f, double outwards_d, double sign, const auto& value) {
    list.push_back(edge_of(scale, shape, outwards_f, outwards_d, sign, value));
  };
  if (way.a2 > 0) {
    list.push_back(side_of(scale, 0, -1, shape.f_low, way.a2 / scale.a_cap));
  }
  list.push_back(side_of(scale, 0, 1, shape.f_high, 1));
  list.push_back(side_of(scale, 1, 1, shape.delta_high, 1));
  if (way.delta_hinders_return()) {
    add(1, 1, 1,
        [&way](double a, double d) { return less(reach_edge(way, a, d), way.v_low * way.v_low); });
  } else if (way.n > 0 && way.v_low == 0) {
    add(1, -1, 1, [&way](double a, double d) {
      const unit::EdgeSpeed notch = returning_notch(way, a);
      return unit::EdgeSpeed{notch.square - 2 * d, notch.by_a, -2};
    });
  }
  if (way.is_papers_task()) {  // (26), (27), which are linear in y
    add(-1, -1, 1, [&way](double a, double d) {
      const Criterion criterion = way.problem.criterion;
      return unit::EdgeSpeed{(unit::delta1(criterion, a) - d) / way.d_cap,
                             unit::delta1_slope(criterion, a) / way.d_cap, -1 / way.d_cap};
    });
    return list;
  }
  if (way.stops_last()) {
    add(-1, -1, -1, [&way](double a, double d) { return less(last_edge(way, a, d), 1); });
  }
  if (way.stops_early()) {
    add(-1, -1, -1, [&way](double a, double d) { return less(stop_edge(way, a, d), 1); });
  }
  return list;
}

/// p T / pi, and its slopes if they are wanted. Without a residual the hit stops at the n-th
/// arrival. With one it may end in any way, so they are taken as differences.
double half_turns(const Way& way, double a, double d, double* by_a, double* by_d) {
  const auto over_pi = [](double phase) { return phase / std::numbers::pi; };
  if (way.q == 0) {
    const unit::Course course = unit::course(way.n, a, d);
    if (by_a != nullptr) {
      *by_a = over_pi(course.by_a);
      *by_d = over_pi(course.by_d);
    }
    return over_pi(course.phase);
  }
  const auto turns = [&](double at_a, double at_d) {
    return over_pi(unit::rest(at_a, at_d, way.passages()).phase);
  };
  if (by_a != nullptr) {
    constexpr double step = 1e-6;
    *by_a = (turns(a * (1 + step), d) - turns(a * (1 - step), d)) / (2 * step * a);
    *by_d = d > 0 ? (turns(a, d * (1 + step)) - turns(a, d * (1 - step))) / (2 * step * d) : 0;
  }
  return turns(a, d);
}

double cost_at(const Way& way, Objective objective, double a, double d) {
  return objective == Objective::time ? half_turns(way, a, d, nullptr, nullptr)
                                      : objective_value(objective, a);
}

/// S grows with f, so f replaces it: it keeps its slope towards 0, where SLSQP would otherwise get
/// lost.
Function cost_of(const Way& way, const Scaled& scale, Objective objective, Tried& tried) {
  return [&way, &tried, scale, objective](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    const double a = at[0] * scale.a_cap;
    const double d = at[1] * scale.d_cap;
    tried.x.push_back(at[0]);
    if (objective == Objective::time) {
      double by_a = 0;
      double by_d = 0;
      const bool sloped = gradient.size() > 0;
      const double turns = half_turns(way, a, d, sloped ? &by_a : nullptr, &by_d);
      scale.slopes(gradient, by_a, by_d, 0);
      return turns;
    }
    const bool force = objective == Objective::acceleration;
    scale.slopes(gradient, force ? 1 : objective_slope(objective, a), 0, 0);
    return force ? a : objective_value(objective, a);
  };
}

/// The cost for algorithms without constraints: above every value inside where one is violated.
Function penalised(const Way& way, const Scaled& scale, bool robust, const Function& cost,
                   const std::vector<Function>& inequalities, Tried& tried) {
  return [&way, &tried, scale, robust, cost = cost, inequalities = inequalities](
             const Eigen::VectorXd& at, Eigen::VectorXd& /*gradient*/) {
    const double above_all = 10.0 + way.passages();  // a half-cycle takes pi
    Eigen::VectorXd none;
    double violation = 0;
    for (const Function& condition : inequalities) {
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
  const double y = scale.d_cap > 0 ? start.delta / way.square() / scale.d_cap : 0;
  const Eigen::Vector3d from(way.scaled(start.f) / scale.a_cap, y, scale.tolerance);
  const Eigen::Index size = by_box ? 3 : 2;
  NloptProblem posed;
  posed.lower = Eigen::Vector3d(least_x, 0, scale.tolerance).head(size);
  posed.upper = Eigen::Vector3d(1, 1, std::max(almost_all, scale.tolerance)).head(size);
  posed.start = from.head(size);
  const Function cost = cost_of(way, scale, objective, tried);
  const auto inequalities = conditions_of(way, scale);
  if (support == ConstraintSupport::yes) {
    posed.constraints = inequalities;
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
  posed.objective = penalised(way, scale, robust, cost, inequalities, tried);
  return posed;
}

}  // namespace stillpoint::design
