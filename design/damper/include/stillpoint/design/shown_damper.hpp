// SPDX-License-Identifier: MIT
#pragma once

// A damper for hits or pulses with the motion that its answer shows.

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/design_result.hpp>
#include <stillpoint/design/region_result.hpp>

#include <optional>

namespace stillpoint::design {

// It is never made without a task. NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct ShownDamper {
  const Problem& problem;
  const Limits& limits;
  const std::optional<Pulse>& pulse;
  const PulseRanges& ranges;
  DesignPoint point;
  const Judged& judged;
  const Response& response;        ///< with the notch that will be built, if there is one
  const MotionEnergies& energies;  ///< the same
  const PulseMotion* under_pulse{nullptr};
  const BuiltNotch* built{nullptr};
  bool admissible{true};

  /// Of the ranges of a pulse, with the paper's notch.
  [[nodiscard]] const PulseWorst* worst() const;
  /// Of the ranges that were tried with the notch as built.
  [[nodiscard]] const WorstMotions* tried() const;
  /// Of ranges, the spring of the motion.
  [[nodiscard]] double p() const { return under_pulse != nullptr ? under_pulse->p : problem.p; }
  /// The largest |x|.
  [[nodiscard]] double peak() const;
  /// What the mass feels: outside the notch, of one as built inside it as well.
  [[nodiscard]] double felt() const;
  /// What it feels outside one as built, if that is less.
  [[nodiscard]] std::optional<double> felt_outside() const;
};
/// Of a design with a damper.
[[nodiscard]] ShownDamper shown_damper(const DesignResult& design,
                                       const std::optional<BuiltNotch>& built);
/// Of a damper that was judged and has a motion.
[[nodiscard]] ShownDamper shown_damper(const RegionRequest& request, const RegionAnswer& answer);

/// Its motion, with the notch that will be built.
[[nodiscard]] SimulationRequest motion_of(const ShownDamper& damper);

/// Whether by more than rounding.
[[nodiscard]] constexpr bool exceeds(double value, double limit) {
  return value > limit * (1 + 1e-9);
}
/// What a mass that starts at x = 0 feels outside the notch, if it feels more in it.
[[nodiscard]] std::optional<double> felt_outside(const Oscillator& damper, double felt, double peak,
                                                 const std::optional<double>& notch_width);

}  // namespace stillpoint::design
