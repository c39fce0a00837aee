// SPDX-License-Identifier: MIT
#include <stillpoint/design/works_for.hpp>

#include "nearest_fit.hpp"
#include "region/edges.hpp"
#include "region/limit_table.hpp"
#include "way/way.hpp"
#include "wide.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/strips.hpp>
#include <stillpoint/design/tolerance.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

std::optional<WorksFor> works_for(const Problem& problem, const Limits& limits, double f,
                                  double delta) {
  Limits of_the_point = limits;
  of_the_point.tolerance = 0;
  if (!admissible(problem, of_the_point, f, delta)) {
    return std::nullopt;
  }
  // One hit and one spring are each changed alone, as the way of the damper allows: between the
  // strips the mass rests off centre, so no interval continues into another one. Without constant
  // friction the strips touch, and way 0 covers all. A range is extended, one end after the other.
  const bool plain = is_plain(problem, limits);
  const int n = !plain || f == 0 ? 0 : static_cast<int>(arrival_of(problem, f, delta).value());
  Problem base = problem;
  base.v0_low = plain ? std::nullopt : std::optional(problem.v0_low.value_or(problem.v0));
  base.p_high = plain ? std::nullopt : std::optional(problem.stiffest_p());
  const auto v0_low = [](Problem& now) -> double& { return now.v0_low ? *now.v0_low : now.v0; };
  const auto v0_high = [](Problem& now) -> double& { return now.v0; };
  const auto p_low = [](Problem& now) -> double& { return now.p; };
  const auto p_high = [](Problem& now) -> double& { return now.p_high ? *now.p_high : now.p; };
  const auto holds = [&](const auto& input, double value) {
    Problem now = base;
    input(now) = value;
    return plain ? admissible(Way(now, of_the_point, n), f, delta)
                 : admissible(now, of_the_point, f, delta);
  };
  const auto end = [&](const auto& input, double farthest) {
    return *nearest_fit(farthest, input(base), [&](double value) { return holds(input, value); });
  };
  const Interval of_v0 = valid_v0(problem);
  const Interval of_p = valid_p(problem);
  const double weakest = v0_low(base);
  WorksFor served;
  served.v0 = {weakest == 0 ? 0 : end(v0_low, std::min(weakest, of_v0.low)),
               end(v0_high, std::max(problem.v0, of_v0.high))};
  served.p.low = end(p_low, std::min(problem.p, of_p.low));
  // At delta = v0^2/2 the stop of one hit allows any p, which rounding hides at the largest.
  const bool bounded = !plain || 2 * Wide(delta) < Wide(problem.v0) * problem.v0 ||
                       figures_edge(problem, limits) < HUGE_VAL;
  if (const double most = std::max(p_high(base), of_p.high); bounded && !holds(p_high, most)) {
    served.p.high = end(p_high, most);
  }
  return served;
}

}  // namespace stillpoint::design
