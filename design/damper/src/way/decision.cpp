// SPDX-License-Identifier: MIT
// What a way admits, and at which arrival a damper stops a hit: in Wide and rounded once, so that
// strict edges are right to the last bit.

#include "region/edges.hpp"
#include "way/way.hpp"
#include "wide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/box_shape.hpp>
#include <stillpoint/design/strips.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

Wide widened_reach(const Way& way, double f) {
  const Wide phi = Wide(f) / way.problem.p;
  return std::max((1 + way.problem.breakaway) * phi,
                  3 * phi - Wide(way.problem.p) * residual_of(way.problem));
}

/// As the edges of the way have it, to rounding.
bool admissible_damped(const Way& way, const Interval& of_f, const Interval& of_delta) {
  const double low = way.scaled(of_f.low);
  const double high = way.scaled(of_f.high);
  const double least = of_delta.low / way.square();
  const double most = of_delta.high / way.square();
  const bool reaches =
      way.n == 0 || (way.v_low > 0 ? reach_edge(way, high, most).square <= way.v_low * way.v_low
                                   : returning_notch(way, high).square <= 2 * least);
  return reaches && (!way.stops_last() || last_edge(way, low, least).square > 1) &&
         (!way.stops_early() || stop_edge(way, low, least).square > 1);
}

/// The square of V0 that reaches, or twice the Delta that sends every hit back.
Wide reach_square(const Way& way, double f, double delta) {
  const WideNotch corner{Wide(f) / way.problem.p, 2 * delta};
  return corner.square_before(widened_reach(way, f), way.returns_by_delta() ? 0 : way.n - 1);
}

Wide pass_speed(const Way& way, double f, double delta) {
  const Problem& problem = way.problem;
  const double p = problem.stiffest_p();
  const double r = residual_of(problem);
  const double c = stop_radius(problem);
  const auto speed = [&](Wide phi, Wide radius, int steps) {
    return root(WideNotch{phi, 2 * delta}.square_before(radius, steps));
  };
  Wide least = HUGE_VAL;
  if (way.stops_last()) {
    const Wide phi = Wide(f) / p;
    least = speed(phi, c * phi, way.passages());
  }
  if (way.stops_early()) {
    const double soft = way.problem.p;
    const double held = problem.breakaway;
    const Wide at = r > 0 ? std::max(Wide(f), Wide(r) * soft * soft / held) : Wide(f);
    const Wide spring = r > 0 ? std::min(Wide(p), root(held * at / r)) : Wide(p);
    const Wide phi = at / spring;
    least = std::min(least, speed(phi, c * phi + r * spring, way.n));
  }
  return least;
}

}  // namespace

bool admissible(const Way& way, double f, double delta, double tolerance) {
  const Problem& problem = way.problem;
  const auto [of_f, of_delta] = box_about({f, delta, tolerance}, way.limits.shape);
  if (!(of_f.low >= way.f2 && of_f.high <= way.f_cap && of_delta.high <= way.delta_cap)) {
    return false;
  }
  if (problem.zeta.high > 0) {
    return admissible_damped(way, of_f, of_delta);
  }
  if (way.is_papers()) {  // by the edges that the region reports, themselves
    return of_f.high <= way.tip && of_delta.low > unchecked_delta1(problem, of_f.low);
  }
  if (way.n > 0 && way.v_low == 0 &&
      2 * of_delta.low < reach_square(way, of_f.high, of_delta.low)) {
    return false;
  }
  if (way.n > 0 && way.v_low > 0 &&
      problem.v0_low.value_or(problem.v0) <
          rounded_up(root(reach_square(way, of_f.high, of_delta.high)))) {
    return false;
  }
  return problem.v0 < rounded_up(pass_speed(way, of_f.low, of_delta.low));
}

bool admissible(const Way& way, double f, double delta) {
  return admissible(way, f, delta, way.limits.tolerance);
}

WaySpeeds way_speeds(const Way& way, double f, double delta) {
  const Wide reach = way.n > 0 ? reach_square(way, f, delta) : 0;
  return {way.returns_by_delta() ? rounded_up(reach.times(0.5)) : rounded_up(root(reach)),
          rounded_up(pass_speed(way, f, delta))};
}

Problem strongest_hit(Problem problem) {
  problem.v0_low = problem.p_high = problem.residual = std::nullopt;
  problem.criterion = Criterion::exact;
  return problem;
}

DecidingArrival deciding_arrival(const Problem& problem, double f, double delta) {
  const Edges edge = edges(problem, {});
  if (!(delta <= edge.delta_cap && f <= edge.f3)) {
    return {1, false};
  }
  if (delta > unchecked_delta1(problem, f)) {
    return {1, true};
  }
  const WideNotch notch{Wide(f) / problem.p, 2 * delta};
  // The least V0 whose first half-cycle has that radius or a larger one.
  const auto speed = [&](Wide radius) { return rounded_up(root(notch.square_before(radius, 0))); };
  Wide reach = 3 * notch.phi;
  Wide pass = notch.before(stop_radius(problem) * notch.phi);
  for (int n = 2; n <= problem.arrivals; ++n) {
    reach = notch.before(reach);
    pass = notch.before(pass);
    if (problem.v0 < speed(reach)) {
      return {n, false};
    }
    if (problem.v0 < speed(pass)) {
      return {n, true};
    }
  }
  return {static_cast<int>(problem.arrivals), false};
}

std::optional<std::int64_t> arrival_of(const Problem& problem, double f, double delta) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  require_within("delta", delta, 0, largest_square);
  // For ranges, that of the motion shown; in an admissible way the model itself decides.
  const Problem shown = is_plain(problem, {}) ? problem : strongest_hit(problem);
  const auto [n, stops] = deciding_arrival(shown, f, delta);
  return stops ? std::optional<std::int64_t>(n) : std::nullopt;
}

}  // namespace stillpoint::design
