// SPDX-License-Identifier: MIT
#pragma once

// What a search looks for, with which algorithm, and how long.

#include <stillpoint/design/objective.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

struct SearchOptions {
  Objective objective{Objective::robust};
  std::optional<std::string> algorithm{};  ///< from algorithm_names(); default: LD_SLSQP
  int max_evaluations{20'000};             ///< >= 1
  double max_seconds{10};                  ///< > 0
};

/// The NLopt algorithms to choose from.
[[nodiscard]] std::vector<std::string_view> algorithm_names();

/// The version of NLopt that runs, for example "2.7.1".
[[nodiscard]] std::string nlopt_version();

/// Throws InputError, naming the field, unless the algorithm is in the list, max_evaluations >= 1
/// and max_seconds > 0.
void require_valid(const SearchOptions& options);

}  // namespace stillpoint::design
