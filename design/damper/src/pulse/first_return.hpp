// SPDX-License-Identifier: MIT
#pragma once

// What a pulse does with one f: a forced run, ended at its first return by a notch that nothing can
// pass. In units of k and p: k = p = 1, so that f is f/k, a length is x p^2/k, Delta is
// Delta p^2/k^2, time is p tau, and only lambda/p is left.

#include <stillpoint/design/pulse.hpp>

#include <array>
#include <cmath>
#include <optional>

namespace stillpoint::design {

/// The motion from rest to its first return, or to its rest elsewhere.
struct FirstReturn {
  double f{0};
  bool returns{false};  ///< to x = 0, where the notch holds it
  double peak{0};
  double speed{0};         ///< of the arrival
  double time{0};          ///< of the arrival, since the start of the pulse
  double acceleration{0};  ///< the largest transmitted, |W| after the arrival included
  double turns{0};
  /// Delta >= this stops it there: half the square of the speed, by the published criterion
  /// f^2/(2 p^2) more, as for a hit.
  double exact_need{0};
  double published_need{0};
  double need_slope{0};  ///< of exact_need over f, where it returns
  /// The square of the arrival speed; where the mass rests at |x| short of x = 0 the negative
  /// |x| (|x| - 2 f) or a swing's like it. Smooth in f where the one becomes the other.
  double clearance{0};
  /// 2 a y of the turn nearest to x = 0 on the way in, with the acceleration a that turns it: what
  /// w^2 is short of there. Infinite where it never turns on the way in.
  double shortfall{HUGE_VAL};

  [[nodiscard]] double need(Criterion criterion) const {
    return criterion == Criterion::exact ? exact_need : published_need;
  }
  [[nodiscard]] double slope(Criterion criterion) const {
    return criterion == Criterion::exact ? need_slope : need_slope + f;
  }
};

/// More than the energy of any arrival, so the notch holds it.
inline constexpr double unpassable = 1e250;

/// The pulse in units of k and p.
[[nodiscard]] Pulse unit_pulse(const Pulse& pulse, double p);

/// One run of the pulse with that f, in units of k and p; the pulse is in its own units.
[[nodiscard]] FirstReturn first_return(const Pulse& pulse, double p, double f, double zeta = 0);

/// The same without a search for events, docs/theory.md section 16, of the pulse in units of k and
/// p with friction f < 1; empty for a kind without a closed form, and for a full sine that is very
/// short, whose speed is a small difference. Accurate to a few roundings, except for what an f
/// barely below 1 amplifies.
[[nodiscard]] std::optional<FirstReturn> closed_return(const Pulse& pulse, double f);

/// The quantities that grow with k and fall with p, and others bounded from above.
inline constexpr std::array bounded_figures{&FirstReturn::peak, &FirstReturn::time,
                                            &FirstReturn::acceleration, &FirstReturn::exact_need,
                                            &FirstReturn::published_need};

/// Each figure is the larger, and it returns if both do.
void take_worse(FirstReturn& worst, const FirstReturn& other);

/// A motion of the unit pulse on the unit spring as that of the load k on the spring p, both over
/// the units: (60) of docs/theory.md.
[[nodiscard]] FirstReturn rescaled(FirstReturn motion, double k, double p);

}  // namespace stillpoint::design
