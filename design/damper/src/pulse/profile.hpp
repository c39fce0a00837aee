// SPDX-License-Identifier: MIT
#pragma once

// What a pulse does for every f, docs/theory.md section 8: one run each. In units of k and p, as
// first_return.hpp.

#include "pulse/first_return.hpp"

#include <stillpoint/design/pulse.hpp>

#include <vector>

namespace stillpoint::design {

/// f closer to k are ignored. A full sine returns up to k, where nothing moves; there its two
/// slips are (1 - f)^2/lambda^2 long and cancel but for (p/lambda)^2 of them, so that closer to k
/// rounding would decide how fast the mass comes back.
inline constexpr double nearest_to_k = 1 - 1e-4;

/// One run of the pulse with that f, in units of k and p; the pulse is in its own units.
[[nodiscard]] FirstReturn first_return(const Pulse& pulse, double p, double f);

/// Motions over f, dense enough to know where the mass returns and where the motion changes its
/// kind: there two neighbours differ by a relative 1e-14.
class PulseProfile {
 public:
  /// Also with the maxima of need/f^2 if k has a range: docs/theory.md section 15.
  PulseProfile(const Pulse& pulse, double p, Criterion criterion, bool k_varies = false);

  [[nodiscard]] FirstReturn at(double f) const;
  [[nodiscard]] const std::vector<FirstReturn>& samples() const { return samples_; }

 private:
  void add_changes(const FirstReturn& to, bool k_varies);
  void add_maxima(Criterion criterion, bool k_varies);

  Pulse pulse_;
  std::vector<FirstReturn> samples_;
};

}  // namespace stillpoint::design
