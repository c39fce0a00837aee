// SPDX-License-Identifier: MIT
#include "strip_space.hpp"

#include "scaled_point.hpp"
#include "search_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stillpoint::design {

namespace {

std::vector<Function> conditions_of(const StripTask& task, const Scaled& scaled) {
  std::vector<Function> list;
  if (task.a2 > 0) {
    list.emplace_back([scaled, a2 = task.a2](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
      const double t = scaled.box(at);
      scaled.slopes(gradient, -(1 - t) / scaled.a_cap, 0, at[0]);
      return a2 / scaled.a_cap - at[0] * (1 - t);
    });
  }
  list.emplace_back([scaled](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
    const double t = scaled.box(at);
    scaled.slopes(gradient, (1 + t) / scaled.a_cap, 0, at[0]);
    return at[0] * (1 + t) - 1;
  });
  if (task.limits.delta_max) {
    list.emplace_back(
        [scaled, d_max = task.d_cap](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
          const double t = scaled.box(at);
          const double part = scaled.d_cap / d_max;
          scaled.slopes(gradient, 0, (1 + t) / d_max, at[1] * part);
          return at[1] * part * (1 + t) - 1;
        });
  }
  const auto edge = [&](double sign, const auto& speed) {
    list.emplace_back([scaled, sign, speed](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
      const double corner = 1 + sign * scaled.box(at);
      const double a = at[0] * scaled.a_cap;
      const double d = at[1] * scaled.d_cap;
      const unit::EdgeSpeed now = speed(a * corner, d * corner);
      scaled.slopes(gradient, sign * corner * now.by_a, sign * corner * now.by_d,
                    a * now.by_a + d * now.by_d);
      return sign * (now.square - 1);
    });
  };
  edge(1, [n = task.n](double a, double d) { return unit::reach_edge(n, a, d); });
  edge(-1, [n = task.n, criterion = task.problem.criterion](double a, double d) {
    return unit::stop_edge(criterion, n, a, d);
  });
  return list;
}

}  // namespace

double d_scale(const StripTask& task) {
  return std::min(task.d_cap, 0.5 / (task.n - 1));
}

double strip_cost(const StripTask& task, Objective objective, double a, double d) {
  return objective == Objective::time
             ? unit::course(task.n, a, d).phase / (task.n * std::numbers::pi)
             : objective_value(objective, a);
}

NloptProblem strip_posed(ConstraintSupport support, const StripTask& task, Objective objective,
                         const DesignPoint& start, Tried& tried) {
  const Scaled scaled{task.a_cap, d_scale(task), task.limits.tolerance};
  const bool robust = objective == Objective::robust;
  const bool by_box = robust && support == ConstraintSupport::yes;
  const double x = task.scaled(start.f) / scaled.a_cap;
  const double y = start.delta / task.problem.v0 / task.problem.v0 / scaled.d_cap;
  NloptProblem posed;
  posed.lower = by_box ? Eigen::VectorXd(Eigen::Vector3d(least_x, 0, scaled.tolerance))
                       : Eigen::VectorXd(Eigen::Vector2d(least_x, 0));
  posed.upper = Eigen::VectorXd::Ones(posed.lower.size());
  posed.start = by_box ? Eigen::VectorXd(Eigen::Vector3d(x, y, scaled.tolerance))
                       : Eigen::VectorXd(Eigen::Vector2d(x, y));
  if (by_box) {
    posed.upper[2] = 1.0 / (2 * task.n - 1);
    posed.start[2] = std::min(posed.start[2], posed.upper[2]);
    posed.lower[2] = posed.start[2];
  }
  const auto cost = [&task, &tried, scaled, objective](const Eigen::VectorXd& at,
                                                       Eigen::VectorXd& gradient) {
    const double a = at[0] * scaled.a_cap;
    const double d = at[1] * scaled.d_cap;
    tried.x.push_back(at[0]);
    if (objective != Objective::time) {
      scaled.slopes(gradient, objective_slope(objective, a), 0, 0);
    } else if (gradient.size() > 0) {
      const unit::Course course = unit::course(task.n, a, d);
      const double half_turns = task.n * std::numbers::pi;
      scaled.slopes(gradient, course.by_a / half_turns, course.by_d / half_turns, 0);
    }
    return strip_cost(task, objective, a, d);
  };
  if (support == ConstraintSupport::yes) {
    posed.constraints = conditions_of(task, scaled);
    posed.objective = cost;
    if (by_box) {
      posed.objective = [&tried, scaled](const Eigen::VectorXd& at, Eigen::VectorXd& gradient) {
        tried.x.push_back(at[0]);
        scaled.slopes(gradient, 0, 0, -1);
        return -at[2];
      };
    }
    return posed;
  }
  posed.objective = [&task, &tried, scaled, robust, cost, conditions = conditions_of(task, scaled)](
                        const Eigen::VectorXd& at, Eigen::VectorXd& /*gradient*/) {
    // Above every value inside, as in search_space.cpp.
    constexpr double above_all = 10;
    Eigen::VectorXd none;
    double violation = 0;
    for (const Function& condition : conditions) {
      violation = std::max(violation, condition(at, none));
    }
    double value = above_all + violation;
    if (!(violation > 0)) {
      const auto tolerance = [&] {
        const double square = task.problem.v0 * task.problem.v0;
        return largest_tolerance(task, task.f_of(at[0] * scaled.a_cap),
                                 at[1] * scaled.d_cap * square)
            .value_or(0);
      };
      value = robust ? -tolerance() : cost(at, none);
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
