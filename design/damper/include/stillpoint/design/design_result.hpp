// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/search.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::design {

struct DesignRequest {
  Problem problem;
  Limits limits{};
  SearchOptions search{};
  std::optional<Pulse> pulse{};  ///< in place of problem.v0, which is then not looked at
  PulseRanges pulse_ranges{};
};

/// The design found for an admissible region.
struct Found {
  DesignPoint point;
  /// The one at which it stops the mass (with ranges: after the strongest hit); empty for a rest
  /// off centre, within the residual.
  std::optional<std::int64_t> arrival{};
  std::vector<Constraint> constraints;
  Response response;                   ///< by the half-cycle map, or under the pulse
  std::optional<SearchRecord> search;  ///< empty for a part of a catalogue
  CrossCheck cross_check;
  std::optional<WorksFor> works_for;
  std::optional<Practice> practice;        ///< of `response`
  std::optional<Practice> practice_worst;  ///< for ranges of a hit, of their ends
  std::optional<double> notch_width_min;   ///< as in practice, enough for all ranges
  std::optional<double> delta1_published;  ///< the least Delta for this f; see RegionAnswer
  std::optional<double> delta1_exact;
  std::optional<PulseCheck> pulse;  ///< if a pulse moves the mass
};

/// The whole answer to a request. Without a finding the region is empty.
struct DesignResult : RegionVerdict {
  DesignRequest request;
  std::optional<Found> finding{};
  /// The velocity to which a pulse reduces, of the motion shown; a full sine leaves none.
  std::optional<double> reduced_v0{};
};

/// What a design or a region asks for if a pulse moves the mass.
struct PulseRequest {
  PulseProblem problem;
  Limits limits{};
  SearchOptions search{};
};

/// The request of a design with a pulse. Throws InputError for what a pulse does not take.
[[nodiscard]] PulseRequest pulse_request(const DesignRequest& request);
[[nodiscard]] PulseRequest pulse_request(const RegionRequest& request);

}  // namespace stillpoint::design
