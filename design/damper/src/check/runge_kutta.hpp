// SPDX-License-Identifier: MIT
#pragma once

// The motions of a design by the integrators of design/peers, which share only the rules with the
// kernel. Made to check, not to be fast.

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/suite_task.hpp>

namespace stillpoint::design {

/// What an integrator can say about a motion that comes to rest. Of a free one peak_acceleration is
/// the largest |x''| at the ends of its pieces; arrival_speed that at the last arrival at x = 0, or
/// 0.
struct IntegratedMotion : MotionFigures {
  bool stopped{false};  ///< false: still moving after max_half_cycles
};

/// The free motion from x = 0 as a series of initial-value problems, the paper's (9), by dopri5.
/// `tolerance` is the integrator's, absolute and relative, for x p / v0 and v / v0. Throws
/// InputError unless v0 > 0 and there is some friction.
[[nodiscard]] IntegratedMotion integrate_free_motion(const Oscillator& oscillator, double v0,
                                                     double tolerance,
                                                     double max_half_cycles = 1000);

/// The motion from rest under a pulse up to its first arrival at x = 0 or its rest elsewhere, by
/// dopri5. A passage ends it, with half_cycles = 2 and not stopped. `tolerance` is the
/// integrator's, relative, and absolute of `size`, the peak to expect.
[[nodiscard]] IntegratedMotion integrate_under_pulse(const Oscillator& oscillator,
                                                     const Pulse& pulse, double size,
                                                     double tolerance);

/// By the classical Runge-Kutta method, whose steps are 1/2000 of 1/p and end at the samples. To
/// the rest, unless that takes too many half-cycles; the margin is not known.
[[nodiscard]] SuiteFigures integrate_to_rest(const Oscillator& oscillator, const Surface& surface,
                                             const Excitation& load, const Start& start = {});

}  // namespace stillpoint::design
