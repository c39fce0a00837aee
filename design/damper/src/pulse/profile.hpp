// SPDX-License-Identifier: MIT
#pragma once

// What a pulse does for every f, docs/theory.md section 8: one run each. In units of k and p, as
// first_return.hpp.

#include "pulse/first_return.hpp"

#include <stillpoint/design/pulse.hpp>

#include <array>
#include <functional>
#include <vector>

namespace stillpoint::design {

/// f closer to k are ignored. A full sine returns up to k, where nothing moves; there its two
/// slips are (1 - f)^2/lambda^2 long and cancel but for (p/lambda)^2 of them, so that closer to k
/// rounding would decide how fast the mass comes back.
inline constexpr double nearest_to_k = 1 - 1e-4;

/// Motions over f, close enough to know where the mass returns, where the need jumps and where it
/// is largest: both sides of a jump differ by a relative 1e-14, and each local maximum is a sample.
class PulseProfile {
 public:
  using At = std::function<FirstReturn(double)>;

  /// Of what `at` says, which lies between two unit pulses. Also with the maxima of need/f^2 and of
  /// the time if k has a range: docs/theory.md section 15. Only the f of the window are examined.
  PulseProfile(At at, const std::array<Pulse, 2>& between, Criterion criterion, bool k_varies,
               const Interval& window);

  [[nodiscard]] FirstReturn at(double f) const { return at_(f); }
  [[nodiscard]] const std::vector<FirstReturn>& samples() const { return samples_; }

 private:
  void add_between(const FirstReturn& a, const FirstReturn& b, int depth);
  void add_edge(const FirstReturn& a, const FirstReturn& b, int depth);
  void add_kink(const FirstReturn& a, const FirstReturn& b);
  void add_misses(bool one_pulse);
  void add_maxima_over_square();
  void add_slowest();

  At at_;
  Criterion criterion_;
  /// The load is constant for a time that is not all of the pulse: the need has a kink where it
  /// begins to hold the mass at a turn, at an f that is not known beforehand.
  bool has_flat_{false};
  double largest_{0};  ///< need so far
  std::vector<FirstReturn> samples_;
};

}  // namespace stillpoint::design
