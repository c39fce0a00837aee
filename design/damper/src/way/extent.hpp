// SPDX-License-Identifier: MIT
#pragma once

// How far a way extends in f.

#include "way/way.hpp"

#include <stillpoint/design/problem.hpp>

#include <optional>

namespace stillpoint::design {

/// A point whose box fits; empty if there is none.
struct WayPoint {
  double f{0};
  double delta{0};
};
[[nodiscard]] std::optional<WayPoint> any_point(const Way& way);

/// The f of the centres of all boxes that fit; a lower end of 0 is open. Empty as any_point.
[[nodiscard]] std::optional<Interval> feasible_f(const Way& way);
/// The same for a design: a relative 1e-9 away from where an arrival grazes x = 0 or Delta has no
/// room left, if that leaves any; and a point for the worst case.
struct DesignRange {
  Interval f;
  WayPoint inside;
};
[[nodiscard]] std::optional<DesignRange> design_range(const Way& way);

/// The point of the way with the largest tolerance, which is 0 if none has any.
[[nodiscard]] DesignPoint most_tolerant(const Way& way);
/// The same of all ways, if it has that tolerance at least.
[[nodiscard]] DesignPoint most_tolerant_of_all(const Problem& problem, Limits limits, double least);

}  // namespace stillpoint::design
