// SPDX-License-Identifier: MIT
#pragma once

// A free motion from its start to its end, docs/theory.md sections 2 to 6, written once for double
// and for a multiprecision scalar. Watchers see what happens and add what is requested beyond the
// counts (times: phase_clock.hpp; margin: margin_keeper.hpp); without a watcher none of it is
// computed.

#include "kernel/ending.hpp"
#include "kernel/first_leg.hpp"
#include "kernel/functions.hpp"
#include "kernel/half_cycle_map.hpp"

#include <stillpoint/core/state.hpp>

#include <algorithm>
#include <cmath>
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

namespace detail {

template <class Real>
int side_after(int side, const Real& passages) {
  using std::fmod;
  return fmod(passages, Real(2)) == 0 ? side : -side;
}

/// Completes `run` after its crest.
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
FreeRun<Real> free_run(const BasicOscillator<Real>& oscillator, const BasicStart<Real>& start,
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
        detail::finish(run, leg.side, map, {leg.energy, leg.radius, leg.farthest}, half_cycle_limit,
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
  run.arrival = leg.energy;
  (watchers.arrival(map, leg.energy), ...);
  const Real energy = map.departure(leg.energy);
  if (!(energy > 0)) {
    run.outcome = Outcome::stopped_at_zero;
    return run;
  }
  const Real radius = map.radius(energy);
  const Crest<Real> crest{energy, radius, map.peak(energy, radius)};
  run.passages = 1;
  run.farthest = max(run.farthest, crest.peak);
  run.acceleration = max(run.acceleration, radius);
  (watchers.first_passage(map, energy, radius), ...);
  detail::finish(run, -leg.side, map, crest, half_cycle_limit, watchers...);
  return run;
}

/// The largest |v-| - |v+| at x = 0. A passage takes the more of v the less there is, so the last
/// one takes the most; but a stop may take more, or less. `run` must have ended.
template <class Real>
[[gnu::noinline]] Real largest_jump(const BasicOscillator<Real>& oscillator,
                                    const BasicStart<Real>& start, const FreeRun<Real>& run) {
  using std::max;
  using std::sqrt;
  const HalfCycleMap<Real> map(oscillator);
  if (run.outcome == Outcome::caught_at_start) {
    return magnitude(start.v0);
  }
  if (map.notch == 0 || !run.arrival) {
    return Real(0);
  }
  if (run.outcome != Outcome::stopped_at_zero) {
    return map.jump_before(map.departure(*run.arrival));
  }
  const Real at_stop = sqrt(*run.arrival);
  return run.passages > 0 ? max(at_stop, map.jump_before(map.departure_to(*run.arrival))) : at_stop;
}

}  // namespace stillpoint
