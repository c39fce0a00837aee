// SPDX-License-Identifier: MIT
#pragma once

// What a search looks for, with which algorithm, how it went, and what it found.

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/design/problem.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::design {

/// What makes one admissible damper better than another. The last three optima lie on the edge of
/// the region, so ask for a tolerance with them.
enum class Objective {
  robust,        ///< largest R with every f (1 +- R), Delta (1 +- R) admissible
  amplitude,     ///< least peak displacement: the largest f
  time,          ///< least stop time: the smallest f
  acceleration,  ///< least acceleration of the free motion, transmitted and relative: smallest f
};

/// "robust", "amplitude", "time", "acceleration", in this order.
[[nodiscard]] std::span<const Named<Objective>> enumerators(Objective) noexcept;

/// The objective's value for a motion; empty for `robust`, which a motion does not have, and for
/// the stop time of one that never stops.
[[nodiscard]] std::optional<double> objective_of(Objective objective, const Response& motion);

struct SearchOptions {
  Objective objective{Objective::robust};
  std::optional<std::string> algorithm{};  ///< from algorithm_names(); default: LD_SLSQP
  int max_evaluations{20'000};             ///< >= 1
  double max_seconds{10};                  ///< > 0
};

/// How the search went. `status` is NLopt's own term: XTOL_REACHED or SUCCESS if it converged;
/// ROUNDOFF_LIMITED or FAILURE if the start was so good, or the region so small, that no step could
/// improve it; MAXEVAL_REACHED or MAXTIME_REACHED if the budget was spent, which global algorithms
/// always do. The point is admissible in every case, because it is rechecked.
struct SearchRecord {
  std::string algorithm;
  std::string status;
  int evaluations{0};
  double wall_time_s{0};
};

/// The NLopt algorithms to choose from.
[[nodiscard]] std::vector<std::string_view> algorithm_names();

/// The version of NLopt that runs, for example "2.7.1".
[[nodiscard]] std::string nlopt_version();

/// Throws InputError, naming the field, unless the algorithm is in the list, max_evaluations >= 1
/// and max_seconds > 0.
void require_valid(const SearchOptions& options);

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
