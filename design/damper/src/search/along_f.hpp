// SPDX-License-Identifier: MIT
#pragma once

#include "search/best_point.hpp"
#include "way/extent.hpp"

namespace stillpoint::design {

/// Within the distance that a design keeps from its edges, a later way is no better than an earlier
/// one, nor is NLopt's point than the one along f: its last digits depend on its version and on the
/// processor.
inline constexpr double clearly_better = 1e-8;

/// The least p T / pi of the first half-cycle for a from `low` to `high`. The time of a return to
/// x = 0 grows with a up to a3; if the mass rests before, beyond a3, that falls: (5), (6).
[[nodiscard]] double first_half_turn(double low, double high);

/// Considers the optimum of a way, found along f alone and without NLopt: docs/theory.md sections 8
/// and 12. With +, -, *, / and square roots, and what elementary.hpp makes of them, so that it has
/// the same bits on every machine.
void consider_along_f(const Way& way, Objective objective, const DesignRange& range,
                      BestPoint& best);

}  // namespace stillpoint::design
