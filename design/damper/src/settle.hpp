// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/search.hpp>

namespace stillpoint::design {

/// The interval of f that a design may take: the region's, kept a relative 1e-9 from f3, where the
/// arrival grazes, and from its lower end, where Delta may have no room left, if it is wide enough.
struct DesignInterval {
  double low;
  double high;
};

[[nodiscard]] DesignInterval design_interval(const Problem& problem, const Region& region);

/// The Delta that goes best with an f of the interval: the one with the most tolerance, by (30).
[[nodiscard]] DesignPoint with_best_delta(const Problem& problem, const Limits& limits, double f);

}  // namespace stillpoint::design
