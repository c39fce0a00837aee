// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/pulse.hpp>

namespace stillpoint::design {

/// A point that was found, simulated and checked.
[[nodiscard]] Finding finding_of(const Problem& problem, const Limits& limits,
                                 const SearchResult& found);

/// Follows the design under its pulse and adds the method forced_pulse to the finding's
/// cross-check. Its tolerance is (p / lambda)^2, of which the error of a peak is at most 0.55:
/// docs/forced.md section 8.
[[nodiscard]] PulseCheck check_under_pulse(const PulseProblem& problem, Finding& finding);

}  // namespace stillpoint::design
