// SPDX-License-Identifier: MIT
#pragma once

// The room that a way leaves for Delta at one f, and the tolerance of its points.

#include "way/way.hpp"

#include <stillpoint/design/problem.hpp>

#include <optional>

namespace stillpoint::design {

/// The Delta of the centres of the boxes that fit for one f, over V0^2.
[[nodiscard]] std::optional<Interval> centre_range(const Way& way, double f, double tolerance);

/// The least Delta over V0^2 with which one hit stops at the n-th arrival at the latest.
[[nodiscard]] double d_that_stops_at(int n, double a);
/// The least Delta over V0^2 with which the strongest hit does not pass the last arrival allowed.
[[nodiscard]] double d_of_last_stop(const Way& way, double a);

/// The tolerance of Delta alone that the room for Delta leaves with a box of f of that tolerance,
/// negative if there is none. In [-1, 1]. Where no
/// notch is allowed, how much stronger the strongest hit might be instead, of its V0^2.
[[nodiscard]] double room(const Way& way, double a, double tolerance);
/// No f between these two has any room: no edge of Delta grows with f but that of (57), so their
/// values at the two ends bound those between.
[[nodiscard]] bool no_room_between(const Way& way, double a_low, double a_high, double tolerance);

/// The largest tolerance that f alone leaves.
[[nodiscard]] double tolerance_of_f(const Way& way, double f);
/// The largest tolerance of any Delta for a; negative if there is none, by how much.
[[nodiscard]] double tolerance_at(const Way& way, double a);
/// The largest tolerance of the point; empty if it is not admissible itself.
[[nodiscard]] std::optional<double> largest_tolerance(const Way& way, double f, double delta);

/// The best Delta for an f: with the most tolerance, or of those that fit the box asked for, the
/// least, the middle or the largest.
enum class BestDelta { most_tolerant, least, middle, largest };
[[nodiscard]] double best_delta(const Way& way, double f, BestDelta choice);
/// The most tolerant one.
[[nodiscard]] DesignPoint with_best_delta(const Way& way, double f);

}  // namespace stillpoint::design
