// SPDX-License-Identifier: MIT
#include "search/run.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace stillpoint::design {

namespace {

/// A global algorithm finds the place of the optimum, not its value: after 20,000 points DIRECT_L
/// is 1e-5 off. A local algorithm gets the last fifth of the budget and starts at the best point.
/// A smaller share leaves it short of evaluations; a larger one takes them from the global search.
constexpr double polished_share = 0.2;

}  // namespace

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
