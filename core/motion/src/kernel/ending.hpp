// SPDX-License-Identifier: MIT
#pragma once

// From a peak to the end of a free motion: by a remainder if only one friction acts, otherwise by
// the map. docs/theory.md sections 3 and 5; names as in half_cycle_map.hpp.

#include "kernel/half_cycle_map.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace stillpoint {

/// A peak from which the motion goes on.
template <class Real>
struct Crest {
  Real energy;  ///< v^2 with which the arc that led to it leaves x = 0, or would have left it
  Real radius;  ///< of that arc
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

/// (17): only f. The peaks fall by 2 phi each, so the last one is an exact remainder.
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

/// (18): only Delta. v^2 falls by the notch at each passage: an exact remainder again.
template <class Real, class... Watchers>
Ending<Real> with_point_friction(const HalfCycleMap<Real>& map, const Crest<Real>& crest,
                                 Watchers&... watchers) {
  using std::fmod;
  using std::round;
  Real last = fmod(crest.energy, map.notch);
  if (last == 0) {
    last = map.notch;
  }
  Ending<Real> ending;
  ending.passages = round(Real((crest.energy - last) / map.notch));
  ending.arrival = last;
  ending.at_zero = true;
  (watchers.point_friction(map, ending.passages, last), ...);
  return ending;
}

/// Both frictions: the map, one square root per half-cycle.
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
      map.notch == 0 ? unbounded : static_cast<double>(crest.energy / map.notch);
  const double by_friction =
      map.phi == 0 ? unbounded : static_cast<double>(crest.radius / (2 * map.phi));
  return min(by_notch, by_friction);
}

/// A watcher that lets a map of so many half-cycles be cancelled.
class CancellablePassages {
 public:
  template <class Map, class... Values>
  void arrival(const Map& /*map*/, const Values&... /*values*/) {}
  template <class Map, class... Values>
  void crest(const Map& /*map*/, const Values&... /*values*/) {}
  template <class Map, class... Values>
  void passage(const Map& /*map*/, const Values&... /*values*/) {
    if (++passages_ % between_looks == 0) {
      cancellation_point();
    }
  }

  static constexpr std::int64_t between_looks = 1'000'000;  // some milliseconds

 private:
  std::int64_t passages_{0};
};

/// Not inlined, so that the map of a motion of usual length is.
template <class Real, class... Watchers>
[[gnu::noinline]] Ending<Real> by_cancellable_map(const HalfCycleMap<Real>& map,
                                                  const Crest<Real>& crest, Watchers&... watchers) {
  CancellablePassages passages;
  return by_map(map, crest, watchers..., passages);
}

/// From a crest to the end, by a closed form where there is one.
template <class Real, class... Watchers>
Ending<Real> from_crest(const HalfCycleMap<Real>& map, const Crest<Real>& crest,
                        double half_cycle_limit, Watchers&... watchers) {
  const bool closed_form = map.notch == 0 || map.phi == 0;
  const double limit = closed_form ? largest_square : half_cycle_limit;
  const double bound = passages_bound(map, crest);
  if (bound > limit) {
    throw TooManyHalfCycles(bound, limit);
  }
  if (map.notch == 0) {
    return with_constant_friction(map, crest, watchers...);
  }
  if (map.phi == 0) {
    return with_point_friction(map, crest, watchers...);
  }
  if (bound > static_cast<double>(CancellablePassages::between_looks)) {
    return by_cancellable_map(map, crest, watchers...);
  }
  return by_map(map, crest, watchers...);
}

}  // namespace stillpoint
