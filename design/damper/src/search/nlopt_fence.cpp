// SPDX-License-Identifier: MIT
#include "search/nlopt_fence.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>

#include <nlopt.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>
#include <iterator>

namespace stillpoint::design {

namespace {

// The stopping rules of NloptBudget. Larger ones would show in the digits of a report; smaller ones
// require steps that rounding swallows, and SLSQP then ends in roundoff instead of convergence.
constexpr double xtol_rel = 1e-10;
constexpr double xtol_abs = 1e-11;
/// Anything above 0 lets NLopt end outside the region, where the project's own check refuses it.
constexpr double constraint_tolerance = 0;
constexpr unsigned long seed = 20'081;  // any; fixed, so that every run repeats

/// One function as NLopt calls it, where to keep an exception that must not pass through NLopt, and
/// room for its arguments.
struct Callback {
  const Function* function;
  nlopt::opt* solver;
  std::exception_ptr* failure;
  int* evaluations;
  Eigen::VectorXd point{};
  Eigen::VectorXd slope{};
};

double call(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  auto& self = *static_cast<Callback*>(data);
  ++*self.evaluations;
  try {
    self.point = Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
    if (!self.point.allFinite()) {  // SLSQP's step where its subproblem is degenerate
      self.solver->force_stop();
      return HUGE_VAL;
    }
    self.slope.resize(static_cast<Eigen::Index>(gradient.size()));
    const double value = (*self.function)(self.point, self.slope);
    assert(std::isfinite(value) && self.slope.allFinite());
    std::copy(self.slope.begin(), self.slope.end(), gradient.begin());
    return value;
  } catch (...) {
    *self.failure = std::current_exception();
    self.solver->force_stop();
    return HUGE_VAL;
  }
}

/// A global algorithm finds the place of the optimum, not its value: after 20,000 points DIRECT_L
/// is 1e-5 off. A local algorithm gets the last fifth of the budget and starts at the best point.
/// A smaller share leaves it short of evaluations; a larger one takes them from the global search.
constexpr double polished_share = 0.2;

std::vector<double> to_vector(const Eigen::VectorXd& x) {
  return {x.begin(), x.end()};
}

}  // namespace

const std::vector<NloptAlgorithm>& nlopt_algorithms() {
  using enum ConstraintSupport;
  static const std::vector<NloptAlgorithm> list{
      {"LD_SLSQP", yes},   {"LD_MMA", yes},    {"LD_CCSAQ", yes}, {"LN_COBYLA", yes},
      {"GN_DIRECT_L", no}, {"GN_CRS2_LM", no}, {"LN_SBPLX", no},  {"LN_NELDERMEAD", no},
  };
  return list;
}

NloptOutcome minimise(const NloptProblem& problem, std::string_view algorithm,
                      const NloptBudget& budget) {
  if (algorithm.starts_with("GN_")) {  // no other one draws numbers
    nlopt::srand(seed);
  }
  nlopt::opt solver(std::string(algorithm).c_str(), static_cast<unsigned>(problem.start.size()));
  solver.set_lower_bounds(to_vector(problem.lower));
  solver.set_upper_bounds(to_vector(problem.upper));
  solver.set_xtol_rel(xtol_rel);
  solver.set_xtol_abs(xtol_abs);
  solver.set_maxeval(budget.max_evaluations);
  solver.set_maxtime(budget.max_seconds);
  if (problem.first_step > 0) {
    solver.set_initial_step(problem.first_step);
  }

  std::exception_ptr failure;
  NloptOutcome outcome;
  int constraint_evaluations = 0;
  Callback objective{&problem.objective, &solver, &failure, &outcome.evaluations};
  solver.set_min_objective(call, &objective);
  std::vector<Callback> constraints;
  constraints.reserve(problem.constraints.size());
  for (const Function& constraint : problem.constraints) {
    constraints.push_back({&constraint, &solver, &failure, &constraint_evaluations});
    solver.add_inequality_constraint(call, &constraints.back(), constraint_tolerance);
  }

  // One ulp outside the bounds would throw.
  std::vector<double> x = to_vector(problem.start.cwiseMax(problem.lower).cwiseMin(problem.upper));
  double least = 0;
  try {
    outcome.status = nlopt_result_to_string(static_cast<nlopt_result>(solver.optimize(x, least)));
  } catch (const nlopt::roundoff_limited&) {
    outcome.status = "ROUNDOFF_LIMITED";  // x is set all the same
  } catch (const std::exception& error) {
    if (failure) {
      std::rethrow_exception(failure);
    }
    outcome.status = fmt::format("FAILURE ({})", error.what());
  }
  outcome.x = Eigen::Map<Eigen::VectorXd>(x.data(), problem.start.size());
  return outcome;
}

std::string nlopt_version() {
  return fmt::format("{}.{}.{}", nlopt::version_major(), nlopt::version_minor(),
                     nlopt::version_bugfix());
}

NloptOutcome run(const NloptProblem& posed, std::string_view algorithm,
                 const SearchOptions& options, const std::function<Eigen::VectorXd()>& best) {
  const bool is_global = algorithm.starts_with("GN_") && options.max_evaluations > 1;
  if (!is_global) {
    return minimise(posed, algorithm, {options.max_evaluations, options.max_seconds});
  }
  const int polish = std::max(1, static_cast<int>(polished_share * options.max_evaluations));
  NloptOutcome outcome =
      minimise(posed, algorithm,
               {options.max_evaluations - polish, (1 - polished_share) * options.max_seconds});
  NloptProblem nearby = posed;
  nearby.start = best();
  const NloptOutcome polished =
      minimise(nearby, "LN_SBPLX", {polish, polished_share * options.max_seconds});
  outcome.x = polished.x;
  outcome.evaluations += polished.evaluations;
  return outcome;
}

NloptAlgorithm find_algorithm(const std::optional<std::string>& wanted) {
  const auto& list = nlopt_algorithms();
  if (!wanted) {
    return list.front();
  }
  const auto found = std::ranges::find(list, *wanted, &NloptAlgorithm::name);
  if (found == list.end()) {
    throw InputError("algorithm", wanted->empty() ? "\"\"" : *wanted,
                     fmt::format("must be one of {}{}", fmt::join(algorithm_names(), ", "),
                                 records::suggestion(*wanted, algorithm_names())));
  }
  return *found;
}

std::vector<std::string_view> algorithm_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(nlopt_algorithms(), std::back_inserter(names), &NloptAlgorithm::name);
  return names;
}

void require_valid(const SearchOptions& options) {
  static_cast<void>(find_algorithm(options.algorithm));
  if (options.max_evaluations < 1) {
    throw InputError("max_evaluations", options.max_evaluations, "must be at least 1");
  }
  if (!(options.max_seconds > 0)) {
    throw InputError("max_seconds", options.max_seconds, "must be greater than 0");
  }
}

}  // namespace stillpoint::design
