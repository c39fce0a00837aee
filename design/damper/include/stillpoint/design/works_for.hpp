// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>

#include <optional>

namespace stillpoint::design {

/// Both ends included: they are the last doubles for which the damper still works. Without `high`
/// there is no upper bound.
struct ServedInterval {
  double low{0};
  std::optional<double> high;
  bool ends_search{false};  ///< one end is where the search ended, beyond which it may work as well
};

/// What of a load: V0 of a hit, k of a pulse, a factor on records or on all loads of several cases.
enum class ServedLoad { v0, k, scale };

/// What a damper as built works for.
struct WorksFor {
  ServedInterval hit;  ///< with p as given; always has a `high`
  ServedInterval p;    ///< with the hit as given
  ServedLoad load{ServedLoad::v0};
};

/// The largest intervals around the problem's v0 and p in which (f, delta) itself keeps every
/// condition and limit, without the tolerance; among valid inputs (problem.hpp). Empty if the point
/// is not admissible. docs/theory.md (35) to (38). Throws as admissible() does.
[[nodiscard]] std::optional<WorksFor> works_for(const Problem& problem, const Limits& limits,
                                                double f, double delta);

/// The same for k, from 0 on without friction, and p under a pulse. A narrow window of p in which
/// the damper fails may be missed: docs/theory.md (71), (72). Empty also where nothing moves.
[[nodiscard]] std::optional<WorksFor> works_for(const PulseProblem& problem, const Limits& limits,
                                                double f, double delta);
/// The p that are examined; if the damper works up to an end, that is the end given.
[[nodiscard]] Interval searched_p(const PulseProblem& problem);

}  // namespace stillpoint::design
