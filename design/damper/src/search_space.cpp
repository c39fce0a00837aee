// SPDX-License-Identifier: MIT
#include "search_space.hpp"

#include <stillpoint/design/unit_problem.hpp>

#include <algorithm>
#include <cassert>
#include <numbers>

namespace stillpoint::design {

namespace {

/// t stays below 1, where the box would reach 0.
constexpr double widest_box = 1 - 1e-6;

double objective_slope(Objective objective, double given) {
  const double a = std::min(given, unit::a3);
  switch (objective) {
    case Objective::amplitude:
      return unit::peak_slope(a);
    case Objective::time:
      return unit::stop_phase_slope(a) / std::numbers::pi;
    case Objective::acceleration:
      return a / unit::radius(a);
    case Objective::robust:
      break;
  }
  assert(false && "robust has no objective in a");
  return 0;
}

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

double objective_value(Objective objective, double given) {
  const double a = std::min(given, unit::a3);  // f3 divided by p and V0 may be an ulp above
  switch (objective) {
    case Objective::amplitude:
      return unit::peak(a);
    case Objective::time:
      return unit::stop_phase(a) / std::numbers::pi;
    case Objective::acceleration:
      return unit::radius(a);
    case Objective::robust:
      break;
  }
  assert(false && "robust has no objective in a");
  return 0;
}

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
  // Every objective is below 2 inside the region.
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
