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
  PulseProfile(const Pulse& pulse, double p, bool k_varies = false);

  [[nodiscard]] FirstReturn at(double f) const;
  [[nodiscard]] const std::vector<FirstReturn>& samples() const { return samples_; }

 private:
  void add_maxima(bool k_varies);

  Pulse pulse_;
  std::vector<FirstReturn> samples_;
};

/// Halves the interval until its ends differ by a relative 1e-14, or by 1e-18, which is nothing for
/// an f/k as for a tolerance; returns the one that holds.
template <class Holds>
double last_that_holds(double holds_at, double fails_at, const Holds& holds) {
  constexpr double close = 1e-14;
  constexpr double nothing = 1e-18;
  while (std::abs(fails_at - holds_at) > std::max(nothing, close * std::max(holds_at, fails_at))) {
    const double middle = holds_at + (fails_at - holds_at) / 2;
    (holds(middle) ? holds_at : fails_at) = middle;
  }
  return holds_at;
}

}  // namespace stillpoint::design
