// SPDX-License-Identifier: MIT
#include "search/nlopt_fence.hpp"
#include "any_task.hpp"
#include "damper.hpp"
#include "unit_problem.hpp"
#include "way/space.hpp"

BOOST_AUTO_TEST_SUITE(nlopt_fence_test)

using namespace stillpoint::design_test;
using Eigen::VectorXd;

constexpr NloptBudget plenty{20'000, 10};
/// Of x at a minimum, where the objective is flat.
constexpr double x_tolerance = 1e-6;

struct OwnError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// (x - 0.3)^2 + (y - 0.6)^2 in the unit square.
NloptProblem bowl() {
  NloptProblem problem;
  problem.lower = Eigen::Vector2d(0, 0);
  problem.upper = Eigen::Vector2d(1, 1);
  problem.start = Eigen::Vector2d(0.9, 0.1);
  problem.objective = [](const VectorXd& at, VectorXd& gradient) {
    const Eigen::Vector2d away = at - Eigen::Vector2d(0.3, 0.6);
    gradient = (2 * away).head(gradient.size()).eval();
    return away.squaredNorm();
  };
  return problem;
}

/// The bowl cut by x + y <= 0.5: least at (0.1, 0.4).
NloptProblem cut_bowl() {
  NloptProblem problem = bowl();
  problem.constraints.emplace_back([](const VectorXd& at, VectorXd& gradient) {
    gradient.setOnes();
    return at.sum() - 0.5;
  });
  return problem;
}

/// Also from a start an ulp outside of the bounds, which is moved in.
BOOST_AUTO_TEST_CASE(every_algorithm_finds_the_bottom_of_a_bowl) {
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    for (const Eigen::Vector2d& start :
         {Eigen::Vector2d(0.9, 0.1), Eigen::Vector2d(std::nextafter(1.0, 2.0), -1e-17)}) {
      NloptProblem problem = bowl();
      problem.start = start;
      const NloptOutcome outcome = minimise(problem, algorithm.name, plenty);
      BOOST_TEST_CONTEXT(algorithm.name << ": " << outcome.status) {
        BOOST_TEST((outcome.x - Eigen::Vector2d(0.3, 0.6)).norm() < x_tolerance);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(algorithms_that_take_constraints_come_by_the_constrained_minimum) {
  // Visited, not returned: SLSQP returns the best point that is feasible to the last bit, which may
  // be far worse than one that is outside by 1e-17. So the caller keeps its own best.
  const Eigen::Vector2d least(0.1, 0.4);
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    if (algorithm.constraints == ConstraintSupport::yes) {
      double nearest = 1;
      NloptProblem problem = cut_bowl();
      problem.start = Eigen::Vector2d(0.2, 0.1);
      problem.objective = [&nearest, least, inner = problem.objective](const VectorXd& at,
                                                                       VectorXd& gradient) {
        nearest = std::min(nearest, (at - least).norm());
        return inner(at, gradient);
      };
      const NloptOutcome outcome = minimise(problem, algorithm.name, plenty);
      BOOST_TEST_CONTEXT(algorithm.name << ": " << outcome.status) {
        BOOST_TEST(nearest < 10 * x_tolerance);
        BOOST_TEST(outcome.x.sum() <= 0.5 + x_tolerance);
      }
    }
  }
}

/// In its first call or a later one.
BOOST_AUTO_TEST_CASE(an_exception_is_rethrown_unchanged) {
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    for (const int calls : {1, 3}) {
      const bool constrained = algorithm.constraints == ConstraintSupport::yes;
      for (const bool of_constraint : {false, constrained}) {
        NloptProblem problem = of_constraint ? cut_bowl() : bowl();
        Function& function = of_constraint ? problem.constraints.front() : problem.objective;
        function = [left = of_constraint ? 1 : calls, inner = function](
                       const VectorXd& at, VectorXd& gradient) mutable {
          if (--left == 0) {
            throw OwnError("mine");
          }
          return inner(at, gradient);
        };
        BOOST_TEST_CONTEXT(algorithm.name << ", call " << calls) {
          BOOST_CHECK_EXCEPTION(
              (void)minimise(problem, algorithm.name, plenty), OwnError,
              [](const OwnError& error) { return std::string(error.what()) == "mine"; });
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_is_thrown_need_not_be_a_standard_exception) {
  NloptProblem problem = bowl();
  problem.objective = [](const VectorXd&, VectorXd&) -> double { throw 42; };
  BOOST_CHECK_THROW((void)minimise(problem, "LD_SLSQP", plenty), int);
}

BOOST_AUTO_TEST_CASE(no_function_is_called_with_what_is_not_finite) {
  // Nothing is free to move: the subproblem of SLSQP divides by 0.
  for (const NloptAlgorithm& algorithm : nlopt_algorithms()) {
    if (algorithm.constraints == ConstraintSupport::yes) {
      NloptProblem problem = cut_bowl();
      problem.start = problem.lower = problem.upper = Eigen::Vector2d(0.5, 0.5);
      bool finite = true;
      const auto watched = [&finite](Function& function) {
        function = [&finite, inner = function](const VectorXd& at, VectorXd& gradient) {
          finite = finite && at.allFinite();
          return inner(at, gradient);
        };
      };
      watched(problem.objective);
      watched(problem.constraints.front());
      const NloptOutcome outcome = minimise(problem, algorithm.name, {100, 10});
      BOOST_TEST(finite, algorithm.name << ": " << outcome.status);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_end_has_a_name) {
  BOOST_TEST(minimise(bowl(), "LN_SBPLX", plenty).status == "XTOL_REACHED");
  const NloptOutcome spent = minimise(bowl(), "LN_SBPLX", {7, 10});
  BOOST_TEST(spent.status == "MAXEVAL_REACHED");
  BOOST_TEST(spent.evaluations == 7);
  BOOST_TEST(minimise(bowl(), "GN_CRS2_LM", {1'000'000, 1e-9}).status == "MAXTIME_REACHED");
  NloptProblem crossed = bowl();
  crossed.lower = Eigen::Vector2d(2, 2);  // above the upper bounds
  BOOST_TEST(minimise(crossed, "LN_SBPLX", plenty).status.starts_with("FAILURE"));
}

BOOST_AUTO_TEST_CASE(evaluations_are_those_of_the_objective) {
  int calls = 0;
  NloptProblem problem = cut_bowl();
  problem.objective = [&calls, inner = problem.objective](const VectorXd& at, VectorXd& gradient) {
    ++calls;
    return inner(at, gradient);
  };
  BOOST_TEST(minimise(problem, "LD_SLSQP", plenty).evaluations == calls);
}

BOOST_AUTO_TEST_CASE(every_gradient_of_the_search_is_the_slope_of_its_function) {
  constexpr double step = 1e-6;
  // Of central differences with that step; a million random slopes are within it.
  constexpr double slope_tolerance = 1e-7;
  RandomSource random(701);
  std::size_t compared = 0;
  for (int i = 0; i < 500; ++i) {
    Task task = any_task(random);
    if (task.limits.delta_max == 0.0) {
      task.limits.delta_max.reset();  // without a notch there is no strip of Delta
    }
    const auto last = task.problem.v0_low == 0.0 ? 1 : static_cast<int>(task.problem.arrivals);
    const Way way{task.problem, task.limits, 1 + random.pick(last)};
    for (const Objective objective : objectives) {
      if (objective == Objective::time && way.q > 0) {
        continue;  // it jumps
      }
      Tried tried{{}, HUGE_VAL, {}};
      const NloptProblem problem =
          way_posed(ConstraintSupport::yes, way, objective, {0.1, 0.1, 0}, tried);
      BOOST_TEST(problem.constraints.size() >= 3U);
      std::vector<Function> functions = problem.constraints;
      functions.push_back(problem.objective);
      VectorXd at(problem.start.size());
      for (double& x : at) {
        x = random.uniform(0.05, 0.9);
      }
      VectorXd none;
      const bool comes_back = std::ranges::all_of(
          problem.constraints,
          [&](const Function& constraint) { return constraint(at, none) <= 0; });
      if (objective == Objective::time && !comes_back) {
        functions.pop_back();  // what does not come back has no time of arrival
      }
      compared += functions.size();
      for (std::size_t k = 0; k < functions.size(); ++k) {
        VectorXd slope(at.size());
        functions[k](at, slope);
        for (Eigen::Index j = 0; j < at.size(); ++j) {
          VectorXd below = at;
          VectorXd above = at;
          below[j] -= step;
          above[j] += step;
          const double measured =
              (functions[k](above, none) - functions[k](below, none)) / (2 * step);
          BOOST_TEST(std::abs(slope[j] - measured) <= slope_tolerance * (1 + std::abs(measured)),
                     "way " << way.n << " of " << i << ", " << name(objective) << ", function " << k
                            << ", variable " << j << ": " << slope[j] << " instead of "
                            << measured);
        }
      }
    }
  }
  BOOST_TEST(compared > 8000U);
}

BOOST_AUTO_TEST_CASE(the_penalty_is_above_every_value_inside) {
  const Way way({1, 1, 0.9}, {}, 1);  // 0.1056 <= f <= 0.3536
  for (const Objective objective : objectives) {
    Tried tried{{}, HUGE_VAL, {}};
    const NloptProblem problem =
        way_posed(ConstraintSupport::no, way, objective, {0.2, 0.4, 0}, tried);
    BOOST_TEST(problem.constraints.empty());
    VectorXd none;
    for (const double x : {0.3, 0.6, 0.9, 1.0}) {
      BOOST_TEST(problem.objective(Eigen::Vector2d(x, 1), none) < 2);
    }
    for (const double x : {0.0, 0.1, 0.25}) {
      BOOST_TEST(problem.objective(Eigen::Vector2d(x, 1), none) > 10);
    }
    BOOST_TEST(problem.objective(Eigen::Vector2d(0.9, 0), none) > 10);
  }
}

BOOST_AUTO_TEST_SUITE_END()
