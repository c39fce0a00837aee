// SPDX-License-Identifier: MIT
#pragma once

// A problem with its limits, and each input by the name that a mend gives it.

#include "testing/test.hpp"

#include <stillpoint/design.hpp>

namespace stillpoint::design_test {

struct Task {
  design::Problem problem;
  design::Limits limits;
  std::uint64_t seed{0};  ///< that it was drawn with, one for each

  [[nodiscard]] bool feasible() const {
    return design::admissible_region(problem, limits).feasible;
  }

  /// One that is given.
  double& input(std::string_view name) {
    if (name == "v0" || name == "v0_high") {
      return problem.v0;
    }
    if (name == "p" || name == "p_low") {
      return problem.p;
    }
    if (name == "beta") {
      return problem.beta;
    }
    if (name == "tolerance") {
      return limits.tolerance;
    }
    const auto kinds = design::limit_kinds();
    return (name == "v0_low"   ? problem.v0_low
            : name == "p_high" ? problem.p_high
            : name == "residual"
                ? problem.residual
                : limits.*std::ranges::find(kinds, name, &design::LimitKind::field)->value)
        .value();
  }

  /// A whole number is rounded down.
  [[nodiscard]] Task with(std::string_view name, double value) const {
    Task changed = *this;
    if (name == "arrivals") {
      changed.problem.arrivals = static_cast<std::int64_t>(value);
    } else if (name == "residual") {
      changed.problem.residual = value;
    } else {
      changed.input(name) = value;
    }
    return changed;
  }
};

inline std::string context_of(const Task& task) {
  const auto& [problem, limits, seed] = task;
  std::ostringstream text;
  text.precision(17);
  text << "seed " << seed << ": " << name(problem.criterion)
       << ", v0 = " << problem.v0_low.value_or(problem.v0) << ":" << problem.v0
       << ", p = " << problem.p << ":" << problem.stiffest_p() << ", beta = " << problem.beta
       << ", arrivals = " << problem.arrivals << ", residual = " << problem.residual.value_or(0)
       << ", f_max = " << limits.f_max.value_or(0)
       << ", delta_max = " << limits.delta_max.value_or(0)
       << ", acceleration_max = " << limits.acceleration_max.value_or(0)
       << ", tolerance = " << limits.tolerance << " of " << limits.shape.f_low << " "
       << limits.shape.f_high << " " << limits.shape.delta_low << " " << limits.shape.delta_high;
  return text.str();
}

}  // namespace stillpoint::design_test
