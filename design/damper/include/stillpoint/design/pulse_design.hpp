// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/search.hpp>

namespace stillpoint::design {

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
