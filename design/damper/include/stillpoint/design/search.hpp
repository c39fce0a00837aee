// SPDX-License-Identifier: MIT
#pragma once

// What a search found, and how it went.

#include <stillpoint/design/objective.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search_options.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace stillpoint::design {

/// How the search went. `status` is NLopt's own term: XTOL_REACHED or SUCCESS if it converged;
/// ROUNDOFF_LIMITED or FAILURE if the start was so good, or the region so small, that no step could
/// improve it; MAXEVAL_REACHED or MAXTIME_REACHED if the budget was spent, which global algorithms
/// always do. The point is admissible in every case, because it is rechecked.
struct SearchRecord {
  struct Scan {
    std::int64_t points{0};
    std::int64_t feasible{0};  ///< boxes within the limits
  };
  std::string algorithm{};
  std::string status{};
  std::int64_t evaluations{0};
  double wall_time_s{0};
  /// The objective's value of the best point that NLopt saw, and of the best along f alone, which
  /// is found without it: the tolerance, the peak, the stop time or the transmitted acceleration.
  std::optional<double> by_nlopt{};
  std::optional<double> along_f{};
  std::optional<Scan> scan{};  ///< of boxes under records, without NLopt
  bool interrupted{false};     ///< the best so far; a whole search may find a better one
};

struct SearchResult {
  DesignPoint point;
  SearchRecord record;
};

/// The best (f, Delta) of the region within the limits; empty if the region is empty or contains no
/// double. If the objective does not depend on Delta, Delta is in the middle of the range that
/// is feasible for the box of f, which has the most tolerance. On an open edge the design stays a
/// relative 1e-9 inside. The point has the same bits on every machine, unless NLopt's
/// is better than the one along f by more than 1e-8. Throws InputError.
/// docs/theory.md section 8.
[[nodiscard]] std::optional<SearchResult> search(const Problem& problem, const Limits& limits,
                                                 const SearchOptions& options = {});

}  // namespace stillpoint::design
