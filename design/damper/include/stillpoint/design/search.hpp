// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/region.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stillpoint::design {

/// What makes one admissible damper better than another. The last three lie on the region's edge,
/// so ask for a tolerance with them.
enum class Objective {
  robust,        ///< largest R with every f (1 +- R), Delta (1 +- R) admissible
  amplitude,     ///< least peak displacement: f as large as may be
  time,          ///< least stop time: f as small as may be
  acceleration,  ///< least peak acceleration: f as small as may be
};

/// "robust", "amplitude", "time" or "acceleration".
[[nodiscard]] std::string_view name(Objective objective) noexcept;
/// The objective of that name; empty where there is none.
[[nodiscard]] std::optional<Objective> parse_objective(std::string_view name) noexcept;
/// All of them, `robust` first.
[[nodiscard]] std::span<const std::string_view> objective_names();

/// A damper and how far it may be off.
struct DesignPoint {
  double f{0};
  double delta{0};
  double tolerance{0};  ///< the largest R that it withstands
};

struct SearchOptions {
  Objective objective{Objective::robust};
  /// An NLopt algorithm out of algorithm_names(); empty: LD_SLSQP.
  std::string algorithm{};
  int max_evaluations{20'000};  ///< >= 1
  double max_seconds{10};       ///< > 0
};

/// How the search went. `status` is NLopt's own word for it: XTOL_REACHED or SUCCESS where it
/// converged; ROUNDOFF_LIMITED or FAILURE where the start was so good, or the region so small, that
/// no step made sense to it; MAXEVAL_REACHED and MAXTIME_REACHED where the budget is spent, as
/// global algorithms always do. The point is admissible whatever it says, because it is rechecked.
struct SearchRecord {
  std::string algorithm;
  std::string status;
  int evaluations{0};
  double wall_time_s{0};
};

struct SearchResult {
  DesignPoint point;
  SearchRecord record;
};

/// The NLopt algorithms that can be asked for.
[[nodiscard]] std::span<const std::string_view> algorithm_names();

/// The version of NLopt that runs, "2.7.1" for instance.
[[nodiscard]] std::string nlopt_version();

/// Throws InputError, naming the field, unless the algorithm is in the list, max_evaluations >= 1
/// and max_seconds > 0.
void require_valid(const SearchOptions& options);

/// The best (f, Delta) of the region that the limits leave; empty where that is empty, or holds no
/// point in doubles. Where the objective leaves Delta free, it is the Delta in the middle of what
/// the box of f leaves, which has the most tolerance. On an open edge the design stays a relative
/// 1e-9 inside. Throws InputError. docs/theory.md section 8.
[[nodiscard]] std::optional<SearchResult> search(const Problem& problem, const Limits& limits,
                                                 const SearchOptions& options = {});

}  // namespace stillpoint::design
