// SPDX-License-Identifier: MIT
#pragma once

#include "search/nlopt_fence.hpp"

#include <stillpoint/design/search_options.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace stillpoint::design {

/// The default one for an empty name. Throws InputError.
[[nodiscard]] NloptAlgorithm find_algorithm(const std::optional<std::string>& wanted);

/// Minimises; after a global algorithm a local one continues from `best`, the best point so far.
[[nodiscard]] NloptOutcome run(const NloptProblem& posed, std::string_view algorithm,
                               const SearchOptions& options,
                               const std::function<Eigen::VectorXd()>& best);

}  // namespace stillpoint::design
