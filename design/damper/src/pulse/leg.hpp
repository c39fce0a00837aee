// SPDX-License-Identifier: MIT
#pragma once

// Some of the pulses and springs that stand for all of the ranges of lambda and p: one leg of (61)
// of docs/theory.md. In units of the strongest pulse, k, and of the softest spring, p, as
// first_return.hpp.

#include "pulse/first_return.hpp"

#include <stillpoint/design/pulse.hpp>

#include <array>
#include <vector>

namespace stillpoint::design {

/// The quantities that grow with k and fall with p, and others bounded from above.
inline constexpr std::array bounded_figures{&FirstReturn::peak, &FirstReturn::time,
                                            &FirstReturn::acceleration, &FirstReturn::exact_need,
                                            &FirstReturn::published_need};

/// A motion of the unit pulse on the unit spring as that of the load k on the spring p, both over
/// the units: (60) of docs/theory.md.
[[nodiscard]] FirstReturn rescaled(FirstReturn motion, double k, double p);

/// Pulses and springs along which lambda/p grows, s times from the first: either the spring gets
/// softer or the pulse shorter.
struct Leg {
  Pulse first;  ///< k = 1
  double p{1};
  bool softens{false};
  std::vector<double> stops;  ///< the s to look at

  [[nodiscard]] Pulse pulse_at(double s) const;
  [[nodiscard]] double p_at(double s) const { return softens ? p / s : p; }
  [[nodiscard]] FirstReturn at(double s, double f) const;
};

}  // namespace stillpoint::design
