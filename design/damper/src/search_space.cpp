// SPDX-License-Identifier: MIT
#include "search_space.hpp"

#include "unit_problem.hpp"

#include <algorithm>

namespace stillpoint::design {

namespace {

/// t stays below 1, where the box would reach 0 and with it the end of every formula's range. No
/// region has a tolerance anywhere near, so nothing is lost.
constexpr double widest_box = 1 - 1e-6;

/// Writes the gradient with respect to as many of (x, y, t) as NLopt asks for.
void store(Eigen::VectorXd& gradient, double by_x, double by_y, double by_t) {
  const Eigen::Vector3d all(by_x, by_y, by_t);
  gradient = all.head(gradient.size()).eval();
}

double box(const SearchSpace& space, const Eigen::VectorXd& point) {
  return point.size() == 3 ? point[2] : space.tolerance;
}

std::vector<Function> constraints_of(const SearchSpace& space) {
  std::vector<Function> list;
  if (space.a2 > 0) {
    list.emplace_back([space](const Eigen::VectorXd& point, Eigen::VectorXd& gradient) {
      const double t = box(space, point);
      store(gradient, -(1 - t), 0, point[0]);
      return space.a2 / space.a_cap - point[0] * (1 - t);
    });
  }
  for (const Eigen::Index i : {0, 1}) {
    list.emplace_back([space, i](const Eigen::VectorXd& point, Eigen::VectorXd& gradient) {
      const double t = box(space, point);
      store(gradient, i == 0 ? 1 + t : 0, i == 1 ? 1 + t : 0, point[i]);
      return point[i] * (1 + t) - 1;
    });
  }
  list.emplace_back([space](const Eigen::VectorXd& point, Eigen::VectorXd& gradient) {
    const double t = box(space, point);
    const double a = point[0] * space.a_cap;
    const double slope = unit::delta1_slope(space.criterion, a * (1 - t)) / space.d_cap;
    store(gradient, slope * space.a_cap * (1 - t), -(1 - t), point[1] - slope * a);
    return unit::delta1(space.criterion, a * (1 - t)) / space.d_cap - point[1] * (1 - t);
  });
  return list;
}

}  // namespace

NloptProblem constrained(const SearchSpace& space, double x, double y) {
  NloptProblem problem;
  problem.constraints = constraints_of(space);
  if (space.objective == Objective::robust) {
    problem.lower = Eigen::Vector3d(0, 0, space.tolerance);
    problem.upper = Eigen::Vector3d(1, 1, widest_box);
    problem.start = Eigen::Vector3d(x, y, space.tolerance);
    problem.objective = [space](const Eigen::VectorXd& point, Eigen::VectorXd& gradient) {
      space.visit(point[0], point[1]);
      store(gradient, 0, 0, -1);
      return -point[2];
    };
    return problem;
  }
  problem.lower = Eigen::Vector2d(0, 0);
  problem.upper = Eigen::Vector2d(1, 1);
  problem.start = Eigen::Vector2d(x, y);
  problem.objective = [space](const Eigen::VectorXd& point, Eigen::VectorXd& gradient) {
    space.visit(point[0], point[1]);
    const double a = point[0] * space.a_cap;
    store(gradient, objective_slope(space.objective, a) * space.a_cap, 0, 0);
    return objective_value(space.objective, a);
  };
  return problem;
}

NloptProblem penalised(const SearchSpace& space, double x, double y,
                       const std::function<double(double x, double y)>& tolerance_at) {
  // Every objective is below 2 inside the region: an algorithm never takes a violation for better.
  constexpr double above_all = 10;
  NloptProblem problem;
  problem.lower = Eigen::Vector2d(0, 0);
  problem.upper = Eigen::Vector2d(1, 1);
  problem.start = Eigen::Vector2d(x, y);
  problem.objective = [space, tolerance_at, constraints = constraints_of(space)](
                          const Eigen::VectorXd& point, Eigen::VectorXd& /*gradient*/) {
    space.visit(point[0], point[1]);
    Eigen::VectorXd none;
    double violation = 0;
    for (const Function& constraint : constraints) {
      violation = std::max(violation, constraint(point, none));
    }
    if (violation > 0) {
      return above_all + violation;
    }
    return space.objective == Objective::robust
               ? -tolerance_at(point[0], point[1])
               : objective_value(space.objective, point[0] * space.a_cap);
  };
  return problem;
}

}  // namespace stillpoint::design
