// SPDX-License-Identifier: MIT
#pragma once

// What a pulse does for every f, docs/theory.md section 8: one forced run each, held at its first
// return by a notch that nothing passes. In units of k and p: k = p = 1, so that f is f/k, a length
// is x p^2/k, Delta is Delta p^2/k^2, time is p tau, and only lambda/p is left.

#include <stillpoint/design/pulse.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

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
  /// The square of the arrival speed; where the mass rests at |x| short of x = 0 the negative
  /// |x| (|x| - 2 f) or a swing's like it. Smooth in f where the one becomes the other.
  double clearance{0};

  [[nodiscard]] double need(Criterion criterion) const {
    return criterion == Criterion::exact ? exact_need : published_need;
  }
};

/// One run of the pulse with that f, in units of k and p; the pulse in its own.
[[nodiscard]] FirstReturn first_return(const Pulse& pulse, double p, double f);

/// Motions over f, close enough to know where the mass returns and where the motion changes its
/// kind: there two neighbours differ by a relative 1e-14.
class PulseProfile {
 public:
  /// With the maxima of need/f^2 as well where k has a range: docs/theory.md section 15.
  PulseProfile(const Pulse& pulse, double p, Criterion criterion, bool k_varies = false);

  [[nodiscard]] FirstReturn at(double f) const;
  [[nodiscard]] const std::vector<FirstReturn>& samples() const { return samples_; }

 private:
  void add_changes(const FirstReturn& to, bool k_varies);
  void add_maxima(Criterion criterion, bool k_varies);

  Pulse pulse_;
  std::vector<FirstReturn> samples_;
};

/// How close the ends of an interval are that holds an edge: a relative 1e-14, or 1e-18, which is
/// nothing for an f/k as for a tolerance.
inline double edge_width(double a, double b) {
  constexpr double close = 1e-14;
  constexpr double nothing = 1e-18;
  return std::max(nothing, close * std::max(a, b));
}

/// Halves the interval to that width, or to `enough`; returns the end that holds.
template <class Holds>
double last_that_holds(double holds_at, double fails_at, const Holds& holds, double enough = 0) {
  while (std::abs(fails_at - holds_at) > std::max(enough, edge_width(holds_at, fails_at))) {
    const double middle = holds_at + (fails_at - holds_at) / 2;
    (holds(middle) ? holds_at : fails_at) = middle;
  }
  return holds_at;
}

/// The same where what holds is that a function is >= 0, in a tenth of the steps where it is
/// smooth: Chandrupatla's method, which bisects where the inverse parabola is not to be trusted.
template <class Function>
double last_not_negative(double holds_at, double fails_at, const Function& function) {
  double a = fails_at;
  double b = holds_at;
  double at_a = function(a);
  double at_b = function(b);
  double part = 0.5;
  constexpr int patience = 50;  // where the function jumps, halves are better than any parabola
  for (int step = 0; std::abs(b - a) > edge_width(a, b); ++step) {
    const double now = a + part * (b - a);
    const double at_now = function(now);
    double c = a;
    double at_c = at_a;
    if ((at_now >= 0) != (at_a >= 0)) {
      c = b;
      at_c = at_b;
      b = a;
      at_b = at_a;
    }
    a = now;
    at_a = at_now;
    const double place = (a - b) / (c - b);
    const double value = (at_a - at_b) / (at_c - at_b);
    const bool trusted = value * value < place && (1 - value) * (1 - value) < 1 - place;
    const double least = edge_width(a, b) / 2 / std::abs(b - a);
    part = trusted ? at_a / (at_b - at_a) * at_c / (at_b - at_c) +
                         (c - a) / (b - a) * at_a / (at_c - at_a) * at_b / (at_c - at_b)
                   : 0.5;
    part = least < 0.5 && step < patience ? std::clamp(part, least, 1 - least) : 0.5;
  }
  return at_a >= 0 ? a : b;
}

}  // namespace stillpoint::design
