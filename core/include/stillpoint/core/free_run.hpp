// SPDX-License-Identifier: MIT
#pragma once

// A free motion from its start to its end, docs/theory.md sections 2 to 6, written once for double
// and for a multiprecision scalar. Watchers see what happens and add what is asked for beyond the
// counts (times: phase_clock.hpp; margin: margin_keeper.hpp); without them nothing of it is
// computed.

#include <stillpoint/core/first_leg.hpp>
#include <stillpoint/core/half_cycle_map.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/outcome.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace stillpoint {

/// How a motion ends; all lengths as speeds (times p), as in half_cycle_map.hpp.
template <class Real>
struct FreeRun {
  Outcome outcome{Outcome::never_stops};
  bool moves{true};
  Real passages{0};
  Real turning_points{0};
  Real farthest{0};             ///< p * largest |x|
  Real acceleration{0};         ///< largest |x''| / p away from the notch
  Real rest{0};                 ///< p * x at rest, signed
  std::optional<Real> arrival;  ///< v^2 of the last arrival at x = 0
};

/// A peak from which the motion goes on: the radius of the arc that led to it, and the peak.
template <class Real>
struct Crest {
  Real radius;
  Real peak;
};

/// What follows a crest; `passages` are counted from there.
template <class Real>
struct Ending {
  Real passages{0};
  std::optional<Real> arrival;  ///< v^2 of the last arrival at x = 0, if there was one
  bool at_zero{false};          ///< rests at x = 0; otherwise in the dead zone
  bool swings_back{false};      ///< rests after a swing back from the last peak
  Real rest{0};                 ///< p |x| at rest
};

/// (17): f alone. The peaks fall by 2 phi each, so the last one is an exact remainder.
template <class Real, class... Watchers>
Ending<Real> with_constant_friction(const HalfCycleMap<Real>& map, const Crest<Real>& crest,
                                    Watchers&... watchers) {
  using std::fmod;
  using std::round;
  const Real step = 2 * map.phi;
  Real last = fmod(crest.peak, step);
  if (last == 0) {
    last = step;
  }
  Ending<Real> ending;
  ending.passages = round(Real((crest.peak - last) / step));
  (watchers.constant_friction(map, ending.passages, last), ...);
  if (ending.passages > 0) {
    ending.arrival = last * (last + step);
  }
  if (last == step) {
    ending.arrival = Real(0);
    ending.at_zero = true;
    return ending;
  }
  ending.swings_back = last > map.phi;
  ending.rest = ending.swings_back ? Real(step - last) : last;
  return ending;
}

/// (18): Delta alone. v^2 falls by the notch at each passage: an exact remainder again.
template <class Real, class... Watchers>
Ending<Real> with_point_friction(const HalfCycleMap<Real>& map, const Crest<Real>& crest,
                                 Watchers&... watchers) {
  using std::fmod;
  using std::round;
  const Real energy = crest.peak * crest.peak;
  Real last = fmod(energy, map.notch);
  if (last == 0) {
    last = map.notch;
  }
  Ending<Real> ending;
  ending.passages = round(Real((energy - last) / map.notch));
  ending.arrival = last;
  ending.at_zero = true;
  (watchers.point_friction(map, ending.passages, last), ...);
  return ending;
}

/// Both frictions: the map, one square root a half-cycle.
template <class Real, class... Watchers>
Ending<Real> by_map(const HalfCycleMap<Real>& map, const Crest<Real>& crest,
                    Watchers&... watchers) {
  Real radius = crest.radius;
  Real peak = crest.peak;
  Real energy{0};
  Real arrival{0};
  std::int64_t passages = 0;
  Ending<Real> ending;
  (watchers.crest(map, radius), ...);
  while (map.returns(radius)) {
    arrival = map.arrival(radius);
    (watchers.arrival(map, arrival), ...);
    const Real left = map.departure(arrival);
    if (!(left > 0)) {
      ending.at_zero = true;
      break;
    }
    energy = left;
    radius = map.radius(energy);
    ++passages;
    (watchers.passage(map, arrival, energy, radius), ...);
    (watchers.crest(map, radius), ...);
  }
  ending.passages = Real(passages);
  if (passages > 0 || ending.at_zero) {
    ending.arrival = arrival;
  }
  if (!ending.at_zero) {
    if (passages > 0) {
      peak = map.peak(energy, radius);
    }
    ending.swings_back = !map.rests_at_peak(radius);
    ending.rest = ending.swings_back ? map.swing_back_rest(radius) : peak;
  }
  return ending;
}

/// (16): more passages than this are impossible; each takes the notch of v^2 and 2 phi of the
/// radius.
template <class Real>
double passages_bound(const HalfCycleMap<Real>& map, const Crest<Real>& crest) {
  using std::min;
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const double by_notch =
      map.notch == 0 ? unbounded
                     : static_cast<double>(crest.peak / map.notch * (crest.peak + 2 * map.phi));
  const double by_friction =
      map.phi == 0 ? unbounded : static_cast<double>(crest.radius / (2 * map.phi));
  return min(by_notch, by_friction);
}

/// From a crest to the end, by a closed form where there is one.
template <class Real, class... Watchers>
Ending<Real> from_crest(const HalfCycleMap<Real>& map, const Crest<Real>& crest,
                        double half_cycle_limit, Watchers&... watchers) {
  const bool closed_form = map.notch == 0 || map.phi == 0;
  const double limit = closed_form ? largest_square : half_cycle_limit;
  if (const double bound = passages_bound(map, crest); bound > limit) {
    throw TooManyHalfCycles(bound, limit);
  }
  if (map.notch == 0) {
    return with_constant_friction(map, crest, watchers...);
  }
  if (map.phi == 0) {
    return with_point_friction(map, crest, watchers...);
  }
  return by_map(map, crest, watchers...);
}

namespace detail {

template <class Real>
int side_after(int side, const Real& passages) {
  using std::fmod;
  return fmod(passages, Real(2)) == 0 ? side : -side;
}

/// Completes `run` with what follows its crest.
template <class Real, class... Watchers>
void finish(FreeRun<Real>& run, int side, const HalfCycleMap<Real>& map, const Crest<Real>& crest,
            double half_cycle_limit, Watchers&... watchers) {
  const Ending<Real> ending = from_crest(map, crest, half_cycle_limit, watchers...);
  run.passages += ending.passages;
  run.turning_points += ending.passages + 1;
  if (ending.arrival) {
    run.arrival = ending.arrival;
  }
  if (ending.at_zero) {
    run.outcome = Outcome::stopped_at_zero;
    (watchers.stops_at_zero(map, ending.passages, *ending.arrival), ...);
    return;
  }
  run.outcome = Outcome::stopped_in_dead_zone;
  run.rest = ending.rest * side_after(side, ending.passages);
  if (ending.swings_back) {
    run.turning_points += 1;
  }
  (watchers.stops_in_dead_zone(ending.passages, ending.swings_back), ...);
}

}  // namespace detail

/// One free motion. TooManyHalfCycles is thrown before the first step where the map might take more
/// than `half_cycle_limit`; the closed forms take none and are bounded by 1e300 half-cycles.
template <class Real, class... Watchers>
FreeRun<Real> free_run(const Oscillator<Real>& oscillator, const Start<Real>& start,
                       double half_cycle_limit, Watchers&... watchers) {
  using std::max;
  const HalfCycleMap<Real> map(oscillator);
  const FirstLeg<Real> leg = first_leg(map, start);
  FreeRun<Real> run;
  run.farthest = leg.farthest;
  run.acceleration = leg.acceleration;
  (watchers.first_leg(map, leg), ...);
  switch (leg.end) {
    case FirstLegEnd::no_motion:
      run.moves = false;
      run.rest = leg.rest * leg.side;
      run.outcome = leg.rest == 0 ? Outcome::stopped_at_zero : Outcome::stopped_in_dead_zone;
      return run;
    case FirstLegEnd::caught:
      run.moves = false;
      run.outcome = Outcome::caught_at_start;
      return run;
    case FirstLegEnd::rest:
      run.outcome = Outcome::stopped_in_dead_zone;
      run.turning_points = 1;
      run.rest = leg.rest * leg.side;
      return run;
    case FirstLegEnd::peak:
      if (!map.without_friction()) {
        detail::finish(run, leg.side, map, {leg.radius, leg.farthest}, half_cycle_limit,
                       watchers...);
      }
      return run;
    case FirstLegEnd::arrival:
      break;
  }
  if (map.without_friction()) {
    run.farthest = run.acceleration = leg.radius;
    return run;
  }
  run.arrival = leg.arrival;
  (watchers.arrival(map, leg.arrival), ...);
  const Real energy = map.departure(leg.arrival);
  if (!(energy > 0)) {
    run.outcome = Outcome::stopped_at_zero;
    return run;
  }
  const Real radius = map.radius(energy);
  const Crest<Real> crest{radius, map.peak(energy, radius)};
  run.passages = 1;
  run.farthest = max(run.farthest, crest.peak);
  run.acceleration = max(run.acceleration, radius);
  (watchers.first_passage(map, energy, radius), ...);
  detail::finish(run, -leg.side, map, crest, half_cycle_limit, watchers...);
  return run;
}

}  // namespace stillpoint
