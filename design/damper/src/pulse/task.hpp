// SPDX-License-Identifier: MIT
#pragma once

// One interval of f, in which every box of the tolerance asked for fits that has its sides there.

#include "pulse/region.hpp"
#include "search/nlopt_fence.hpp"
#include "search/objectives.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>

namespace stillpoint::design {

struct PulseTask {
  const PulseRegion& region;
  KnownMotions& known;
  Objective objective{Objective::robust};
  Island part;
  double most_use{1};  ///< of delta_max

  /// The f to choose from.
  [[nodiscard]] Island middles() const {
    const auto [low, high] = region.middles(part, region.asked());
    return {std::min(low, high), high};
  }
  [[nodiscard]] double cost(double f) const {
    return objective == Objective::robust ? -region.widest(part, f, HUGE_VAL, known)
                                          : objective_of(objective, known.at(f));
  }
  /// The need has a local maximum in there.
  [[nodiscard]] bool has_top() const {
    const auto& samples = region.profile()->samples();
    const auto need = [&](std::size_t i) { return samples[i].need(region.criterion()); };
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
      if (part.low < samples[i].f && samples[i].f < part.high && need(i) >= need(i - 1) &&
          need(i) >= need(i + 1)) {
        return true;
      }
    }
    return false;
  }
  /// Whether the cost may be less. A root is not searched for in vain: a box of that tolerance
  /// has to fit.
  [[nodiscard]] bool may_beat(double cost_known, double f) const {
    return objective != Objective::robust || std::isinf(cost_known) ||
           (region.widest_by_edges(part, f) > -cost_known &&
            region.use_of_delta(region.low_of(f, -cost_known), region.high_of(f, -cost_known),
                                -cost_known, known) <= 1);
  }
};

/// The best f so far.
struct PulseBest {
  std::optional<double> f;
  double cost{HUGE_VAL};

  void consider(const PulseTask& task, double f_new) {
    const auto [low, high] = task.middles();
    const double inside = std::clamp(f_new, low, high);
    if (std::isnan(inside) || !task.may_beat(cost, inside)) {
      return;
    }
    const double now = task.cost(inside);
    if (now < cost) {
      f = inside;
      cost = now;
    }
  }
};

/// The optimum along f, without NLopt: the largest box by its edges, the other objectives by
/// sampling and Brent's method.
[[nodiscard]] PulseBest bracketed(const PulseTask& task);

/// As NLopt sees it, in x = f / high of the interval, with an objective of order one. `visit` is
/// told every f.
[[nodiscard]] NloptProblem posed(const PulseTask& task, const NloptAlgorithm& algorithm,
                                 double scale, const std::function<void(double)>& visit);

}  // namespace stillpoint::design
