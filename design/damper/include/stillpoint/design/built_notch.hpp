// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/figures.hpp>

#include <optional>

namespace stillpoint::design {

/// The notch that will be built, if it is not the paper's: docs/notches.md.
struct NotchShape {
  std::optional<double> width{};
  std::optional<double> hold{};  ///< of one without a width
};

/// A hit or a pulse, its spring, and what the mass then does.
struct TriedMotion {
  double v0{0};
  std::optional<Pulse> pulse{};
  double p{1};
  ForcedResponse response{};
  bool from_inside{false};  ///< the paper's notch catches it at the start, so this one acted there

  [[nodiscard]] double rest() const { return response.stop_position.value_or(0); }
};

/// Of all motions that were tried.
struct WorstMotions {
  TriedMotion farthest;  ///< it rests farthest from x = 0
  TriedMotion peak;      ///< these have the largest peak, the largest transmitted acceleration
  TriedMotion felt;
  TriedMotion outside;  ///< and the largest p^2 |x|, which with f is felt outside the notch
};

/// A design with that notch.
struct BuiltNotch {
  NotchShape shape;
  std::optional<double> friction{};  ///< within |x| < width / 2: f + delta / width
  ForcedResponse response;
  MotionEnergies energies{};
  bool changes_nothing{false};  ///< compared with the same motion with the paper's notch
  /// After a hit, with a width: the motion if the notch acts on the way out too, as a strip of that
  /// friction does. v0 is otherwise the speed with which the mass leaves it.
  std::optional<ForcedResponse> from_start{};
  /// Of ranges: of a grid of their hits or pulses and springs, and of the hits that leave the mass
  /// at the end of its dead zone. On hits that the paper's notch catches, a notch with a width acts
  /// from the start.
  std::optional<WorstMotions> worst{};
  bool holds_weakest{false};  ///< the weakest pulse never moves the mass
};

/// The motion of a design, which exists; with a pulse, the motion under the pulse itself, and with
/// ranges of it the motion shown. Throws InputError for a wrong shape, TooManyHalfCycles.
[[nodiscard]] BuiltNotch built_notch(const DesignResult& design, const NotchShape& shape);

}  // namespace stillpoint::design
