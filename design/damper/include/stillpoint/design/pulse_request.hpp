// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design_result.hpp>

namespace stillpoint::design {

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
