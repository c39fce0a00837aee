// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>

#include <optional>

namespace stillpoint::design {

/// Both ends included: they are the last doubles for which the damper still works. Without `high`
/// there is no upper bound.
struct ServedInterval {
  double low{0};
  std::optional<double> high;
};

/// What a damper as built works for.
struct WorksFor {
  ServedInterval v0;  ///< with p as given; always has a `high`
  ServedInterval p;   ///< with v0 as given
};

/// The largest intervals around the problem's v0 and p in which (f, delta) itself keeps every
/// condition and limit, without the tolerance; among valid inputs (problem.hpp). Empty if the point
/// is not admissible. docs/theory.md (35) to (38). Throws as admissible() does.
[[nodiscard]] std::optional<WorksFor> works_for(const Problem& problem, const Limits& limits,
                                                double f, double delta);

}  // namespace stillpoint::design
