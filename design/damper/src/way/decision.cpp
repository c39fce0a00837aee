// SPDX-License-Identifier: MIT
// What a way admits, and at which arrival a damper stops a hit: in Wide and rounded once, so that
// strict edges are right to the last bit.

#include "region/edges.hpp"
#include "way/way.hpp"
#include "wide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/strips.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

Wide widened_reach(const Way& way, Wide f) {
  const Wide phi = f / way.problem.p;
  return std::max(2 * phi, 3 * phi - Wide(way.problem.p) * residual_of(way.problem));
}

/// The square of V0 that reaches, or twice the Delta that sends every hit back.
Wide reach_square(const Way& way, double f, double delta) {
  const WideNotch corner{f / Wide(way.problem.p), 2 * Wide(delta)};
  return corner.square_before(widened_reach(way, f), way.returns_by_delta() ? 0 : way.n - 1);
}

double pass_speed(const Way& way, double f, double delta) {
  const Problem& problem = way.problem;
  const Wide p = problem.stiffest_p();
  const Wide r = residual_of(problem);
  const Wide c = stop_radius(problem);
  const auto speed = [&](Wide phi, Wide radius, int steps) {
    return rounded_up(root(WideNotch{phi, 2 * Wide(delta)}.square_before(radius, steps)));
  };
  double least = HUGE_VAL;
  if (way.stops_last()) {
    least = speed(f / p, c * f / p, way.passages());
  }
  if (way.stops_early()) {
    const Wide at = r > 0 ? std::max<Wide>(f, r * way.problem.p * way.problem.p) : f;
    const Wide spring = r > 0 ? std::min(p, root(at / r)) : p;
    least = std::min(least, speed(at / spring, c * at / spring + r * spring, way.n));
  }
  return least;
}

}  // namespace

bool admissible(const Way& way, double f, double delta, double tolerance) {
  const Problem& problem = way.problem;
  const auto [f_low, f_high, delta_low, delta_high] = sides(way.limits.shape, tolerance);
  if (!(f * f_low >= way.f2 && f * f_high <= way.f_cap && delta * delta_high <= way.delta_cap)) {
    return false;
  }
  if (way.is_papers()) {  // by the edges that the region reports, themselves
    return f * f_high <= way.tip && delta * delta_low > unchecked_delta1(problem, f * f_low);
  }
  if (way.n > 0) {
    const Wide reach =
        reach_square(way, f * f_high, delta * (way.v_low > 0 ? delta_high : delta_low));
    if (!(way.v_low > 0 ? problem.v0_low.value_or(problem.v0) >= rounded_up(root(reach))
                        : 2 * Wide(delta * delta_low) >= reach)) {
      return false;
    }
  }
  return problem.v0 < pass_speed(way, f * f_low, delta * delta_low);
}

bool admissible(const Way& way, double f, double delta) {
  return admissible(way, f, delta, way.limits.tolerance);
}

WaySpeeds way_speeds(const Way& way, double f, double delta) {
  const Wide reach = way.n > 0 ? reach_square(way, f, delta) : 0;
  return {way.returns_by_delta() ? rounded_up(reach / 2) : rounded_up(root(reach)),
          pass_speed(way, f, delta)};
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
  const WideNotch notch{f / Wide(problem.p), 2 * Wide(delta)};
  Wide reach = 3 * notch.phi;
  Wide pass = notch.before(stop_radius(problem) * notch.phi);
  for (int n = 2; n <= problem.arrivals; ++n) {
    reach = notch.before(reach);
    pass = notch.before(pass);
    if (problem.v0 < notch.speed(reach)) {
      return {n, false};
    }
    if (problem.v0 < notch.speed(pass)) {
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
