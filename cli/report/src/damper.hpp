// SPDX-License-Identifier: MIT
#pragma once

// A damper for a hit or a pulse, found by a design or judged by a region, in rows.

#include "sections.hpp"

#include <stillpoint/design/shown_damper.hpp>

#include <string>
#include <string_view>

namespace stillpoint::report {

/// "peak 137.37 mm, at rest after 1.5287 s, 0.09465 g transmitted outside the notch"
[[nodiscard]] std::string does_words(const design::ShownDamper& shown, const Physical& physical);
/// Peak, rest and acceleration, and how wide its notch must be so that a pulse moves the mass.
void add_motion(Section& answer, const design::ShownDamper& shown, const Physical& physical);
/// "a hit of 0.44 m/s and a period of 2.94 s", "k = 0.5 g and p = 1": which motion of a task with
/// ranges is shown; empty without.
[[nodiscard]] std::string shown_motion(const design::ShownDamper& shown, const Physical& physical);
/// What a notch as built is compared with: "has no width", "holds any load", "acts only after the
/// start".
[[nodiscard]] std::string_view ideal_words(const design::ShownDamper& shown);

}  // namespace stillpoint::report
