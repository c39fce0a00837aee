// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search_options.hpp>

#include <optional>

namespace stillpoint::design {

struct SearchResult {
  DesignPoint point;
  SearchRecord record;
};

/// The best (f, Delta) of the region within the limits; empty if the region is empty or contains no
/// double. If the objective does not depend on Delta, Delta is in the middle of the range that
/// is feasible for the box of f, which has the most tolerance. On an open edge the design stays a
/// relative 1e-9 inside. Throws InputError. docs/theory.md section 8.
[[nodiscard]] std::optional<SearchResult> search(const Problem& problem, const Limits& limits,
                                                 const SearchOptions& options = {});

/// The objective's value of the best damper, found along f alone and without NLopt, to compare with
/// the search: the largest tolerance, else the least peak, stop time or acceleration of the
/// motion of the largest peak. Empty if there is no damper, or none with any tolerance. Throws
/// InputError.
[[nodiscard]] std::optional<double> optimum_along_f(const Problem& problem, const Limits& limits,
                                                    Objective objective);

}  // namespace stillpoint::design
