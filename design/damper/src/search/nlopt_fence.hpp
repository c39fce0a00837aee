// SPDX-License-Identifier: MIT
#pragma once

// All use of NLopt: nlopt_fence.cpp is the only file that includes it.

#include <stillpoint/design/search_options.hpp>

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// A function of x; `gradient` is empty (size 0) if the algorithm needs none, else as long as x.
using Function = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

struct NloptProblem {
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  Eigen::VectorXd start;              ///< moved into the bounds if it is outside
  Function objective;                 ///< to be minimised
  std::vector<Function> constraints;  ///< each to be <= 0; only for algorithms that take them
  double first_step{0};               ///< of a local algorithm, in each x; 0: NLopt's own
};

/// The stopping rules, as inequalities: |dx_i| <= 1e-10 |x_i| or |dx_i| <= 1e-11 for every i (x is
/// scaled to order one). No rule on f: with one, SLSQP and COBYLA return infeasible points as a
/// success on a thin curved region.
struct NloptBudget {
  int max_evaluations;
  double max_seconds;
};

struct NloptOutcome {
  Eigen::VectorXd x;
  std::string status;
  int evaluations{0};  ///< of the objective
};

/// Whether NLopt's algorithm takes inequality constraints.
enum class ConstraintSupport { yes, no };

struct NloptAlgorithm {
  std::string_view name;
  ConstraintSupport constraints;
};

/// The algorithms offered, the default one first.
[[nodiscard]] const std::vector<NloptAlgorithm>& nlopt_algorithms();

/// Runs one algorithm. An exception of a callback stops it and is rethrown; a value that is not
/// finite, which would hang some algorithms, is an assertion; a point that is not finite, which
/// SLSQP may step to, ends the run. Seeds NLopt's generator first, so that every run repeats.
[[nodiscard]] NloptOutcome minimise(const NloptProblem& problem, std::string_view algorithm,
                                    const NloptBudget& budget);

/// The default one for an empty name. Throws InputError.
[[nodiscard]] NloptAlgorithm find_algorithm(const std::optional<std::string>& wanted);

/// Minimises; after a global algorithm a local one continues from `best`, the best point so far.
[[nodiscard]] NloptOutcome run(const NloptProblem& posed, std::string_view algorithm,
                               const SearchOptions& options,
                               const std::function<Eigen::VectorXd()>& best);

}  // namespace stillpoint::design
