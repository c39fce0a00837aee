// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design_result.hpp>

#include <optional>
#include <string>

namespace stillpoint::design {

/// The largest R of f and delta at once, for any shape of the box.
[[nodiscard]] double even_tolerance(const Problem& problem, const Limits& limits,
                                    const DesignPoint& point);

/// The same for a result with a finding, also under a pulse.
[[nodiscard]] double even_tolerance(const DesignResult& result);

/// The result in one line for people: the damper and its motion, or why there is none.
[[nodiscard]] std::string summary(const DesignResult& result);

/// Region, search, simulation, cross-check. Throws InputError for wrong input; an empty region and
/// a failed check are results.
[[nodiscard]] DesignResult design(const DesignRequest& request);

/// The answer for a mass that a pulse moves from rest. The region is that of the forced motion
/// itself: docs/theory.md section 8. In it f2 and f3 are the ends of the f that stay within beta
/// and return, beta_min is the least beta without limits, delta2 is empty, since the notch takes
/// nothing from a mass that starts from rest. The finding's `response` is the forced one, and its
/// `pulse` says how far the reduction to a velocity is off; the mends name k
/// and lambda instead of v0. Throws InputError for wrong input.
[[nodiscard]] DesignResult design(const PulseRequest& request);

/// The damper of that answer alone, without the checks and what it works for, for many designs.
struct PulseDamper {
  DesignPoint point;        ///< its tolerance is that of f and delta at once
  ForcedResponse response;  ///< with ranges that of the largest peak
};
[[nodiscard]] std::optional<PulseDamper> damper(const PulseRequest& request);

}  // namespace stillpoint::design
