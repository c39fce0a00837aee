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
struct Found : Judged {
  DesignPoint point;
  Response response;                   ///< by the half-cycle map, or under the pulse
  std::optional<SearchRecord> search;  ///< empty for a part of a catalogue
  CrossCheck cross_check;
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
