// SPDX-License-Identifier: MIT
#pragma once

// What two motions with neighbouring f, a below b, say of those between them: docs/theory.md
// section 8.

#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"

#include <stillpoint/design/problem.hpp>

namespace stillpoint::design {

/// What a box asks for.
[[nodiscard]] Rated need_of(const FirstReturn& motion, Criterion criterion);
/// Of need/f^2: section 15.
[[nodiscard]] Rated need_over_square(const FirstReturn& motion, Criterion criterion);

/// The cubic with these ends rises beyond both of them, or falls and rises between.
[[nodiscard]] bool top_of_cubic(const Rated& a, const Rated& b, double step);

/// The need neither jumps nor turns unseen between the two: their slopes explain what it changes by
/// to 1e-4 of the largest need of all; to 5 % of the change as well where they are of one kind, of
/// which the smaller need counts where it falls to nothing. There the speeds may explain it
/// instead.
[[nodiscard]] bool is_smooth(const FirstReturn& a, const FirstReturn& b, double largest);

/// Of two kinds, Newton's step from the one with fewer turns finds w = 0 before the other one, or
/// halves have not helped.
[[nodiscard]] bool may_jump(const FirstReturn& a, const FirstReturn& b, int depth);

}  // namespace stillpoint::design
