// SPDX-License-Identifier: MIT
#pragma once

// A damper for a hit or a pulse, found by a design or judged by a region, in rows.

#include "sections.hpp"

#include <stillpoint/report/report.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace stillpoint::report {

// It is never made without a task. NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
struct ShownDamper {
  ShownTask task;
  design::DesignPoint point;
  const design::Judged& judged;
  const Response& response;  ///< with the notch that will be built, if there is one
  const design::PulseMotion* under_pulse{nullptr};
  const design::BuiltNotch* built{nullptr};
  bool admissible{true};

  /// Over the ranges of a pulse, with the paper's notch.
  [[nodiscard]] const design::PulseWorst* worst() const {
    return built == nullptr && under_pulse != nullptr && under_pulse->worst ? &*under_pulse->worst
                                                                            : nullptr;
  }
  /// Of ranges, the spring of the motion.
  [[nodiscard]] double p() const {
    return under_pulse != nullptr ? under_pulse->p : task.problem.p;
  }
};
/// Of a design with a damper.
[[nodiscard]] ShownDamper shown_damper(const DesignReport& report);
/// Of a damper that was judged and moves.
[[nodiscard]] std::optional<ShownDamper> shown_damper(const RegionReport& report);

/// "peak 137.37 mm, at rest after 1.5287 s, 0.09465 g transmitted outside the notch"
[[nodiscard]] std::string does_words(const ShownDamper& shown);
/// Peak, rest and acceleration, and how wide its notch must be so that a pulse moves the mass.
void add_motion(Section& answer, const ShownDamper& shown);
/// "the strongest hit, 0.44 m/s, and the softest spring, 2.94 s" or "k = 0.5 g": which motion of a
/// task with ranges is shown; empty without.
[[nodiscard]] std::string shown_motion(const ShownDamper& shown);
/// What a notch as built is compared with: "has no width", "holds any load", "acts only after the
/// start".
[[nodiscard]] std::string_view ideal_words(const ShownDamper& shown);
/// ", with a notch that has no width" behind what is not of the notch as built; empty without one.
[[nodiscard]] std::string with_ideal(const ShownDamper& shown);

}  // namespace stillpoint::report
