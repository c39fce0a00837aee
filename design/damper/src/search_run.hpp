// SPDX-License-Identifier: MIT
#pragma once

#include "nlopt_fence.hpp"

#include <stillpoint/design/search.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::design {

/// The default one for an empty name. Throws InputError.
[[nodiscard]] NloptAlgorithm find_algorithm(const std::string& wanted);

/// Minimises; after a global algorithm a local one goes on from `best`, the best point so far.
[[nodiscard]] NloptOutcome run(const NloptProblem& posed, std::string_view algorithm,
                               const SearchOptions& options,
                               const std::function<Eigen::VectorXd()>& best);

/// The search of a task with several arrivals: the best of the strips.
[[nodiscard]] std::optional<SearchResult> search_arrivals(const Problem& problem,
                                                          const Limits& limits,
                                                          const SearchOptions& options);

/// The search of a task that is not plain (problem.hpp): the best of the ways.
[[nodiscard]] std::optional<SearchResult> search_ways(const Problem& problem, const Limits& limits,
                                                      const SearchOptions& options);

}  // namespace stillpoint::design
