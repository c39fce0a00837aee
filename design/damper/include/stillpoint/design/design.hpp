// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/search.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

struct DesignRequest {
  Problem problem;
  Limits limits{};
  SearchOptions search{};
  std::optional<Pulse> pulse{};  ///< in place of problem.v0; see PulseRequest
};

/// The design found for an admissible region.
struct Finding {
  DesignPoint point;
  /// The one at which it stops the mass (of ranges: after the strongest hit); empty for a rest off
  /// centre, within the residual.
  std::optional<std::int64_t> arrival{};
  std::vector<Constraint> constraints;
  Response response;  ///< by the half-cycle map
  SearchRecord search;
  CrossCheck cross_check;
  /// Empty for a pulse: its velocity depends on f, and the forced motion is what counts.
  std::optional<WorksFor> works_for;
  std::optional<Practice> practice;  ///< of `response`
  std::optional<PulseCheck> pulse;   ///< if a pulse gave the initial velocity
};

/// The whole answer to a request, repeated with the v0 that a pulse leaves. Without a finding the
/// region is empty.
struct DesignResult : RegionVerdict {
  DesignRequest request;
  std::optional<Finding> finding{};
};

/// The largest R of f and delta at once, whatever the shape of the box.
[[nodiscard]] double even_tolerance(const Problem& problem, const Limits& limits,
                                    const DesignPoint& point);

/// The result in one line for people: the damper and its motion, or why there is none.
[[nodiscard]] std::string summary(const DesignResult& result);

/// Region, search, simulation, cross-check. Throws InputError for wrong input; an empty region and
/// a failed check are results.
[[nodiscard]] DesignResult design(const DesignRequest& request);

struct PulseRequest {
  PulseProblem problem;
  Limits limits{};
  SearchOptions search{};
};

/// The answer for the initial velocity that the pulse leaves under the f found, with `pulse` in the
/// finding and forced_pulse as a third method of the cross-check. The point and its tolerance hold
/// with V(f) over the whole box, and at its corners under the pulse itself. f_lower and f_upper of
/// the region bound the f for which such a point exists; its other edges are those of the velocity.
/// The mends name k and lambda instead of v0. Without a design the velocity is that for the largest
/// f that returns. Throws InputError for wrong input. docs/theory.md section 8 and docs/forced.md
/// section 8.
[[nodiscard]] DesignResult design(const PulseRequest& request);

}  // namespace stillpoint::design
