// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

namespace stillpoint::design {

/// What an integrator says about a motion from rest at x = 0 under a record.
struct IntegratedSuiteMotion {
  bool settled{false};     ///< it came to rest within the allowed number of pieces
  double peak{0};          ///< largest |x|
  double acceleration{0};  ///< largest transmitted one
  double residual{0};
};

/// The rules of docs/forced.md section 1 and docs/notches.md section 2 around pieces by the
/// classical Runge-Kutta method, whose steps are at most 1/2000 of 1/p and end at the samples;
/// events are bisected on a step. Shares no code with the kernel.
[[nodiscard]] IntegratedSuiteMotion integrate_record_motion(const Oscillator& oscillator,
                                                            const Surface& surface,
                                                            const Record& record);

}  // namespace stillpoint::design
