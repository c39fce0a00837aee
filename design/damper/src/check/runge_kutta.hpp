// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/pulse.hpp>

namespace stillpoint::design {

/// What an integrator can say about a free motion that comes to rest.
/// peak_acceleration is the largest |x''| at the ends of the monotone pieces; arrival_speed that at
/// the last arrival at x = 0, or 0.
struct IntegratedMotion : MotionFigures {
  bool stopped{false};  ///< false: still moving after max_half_cycles
};

/// The free motion from x = 0 as a series of initial-value problems, the paper's (9): adaptive
/// Runge-Kutta (Boost.Odeint's dopri5 with dense output), passages and turns bracketed between
/// steps and located by Boost.Math's TOMS 748. Shares only the rules with the half-cycle
/// map. Made to check, not to be fast. `tolerance` is the integrator's, absolute and relative,
/// for x p / v0 and v / v0. Throws InputError unless v0 > 0 and there is some friction.
[[nodiscard]] IntegratedMotion integrate_free_motion(const Oscillator& oscillator, double v0,
                                                     double tolerance,
                                                     double max_half_cycles = 1000);

/// The motion from rest under a pulse up to its first arrival at x = 0 or its rest elsewhere, by
/// adaptive Runge-Kutta as integrate_free_motion. It shares only the rules with the kernel. A
/// passage ends it, with half_cycles = 2 and not stopped. `tolerance` is the integrator's,
/// relative, and absolute of `size`, the peak to expect.
[[nodiscard]] IntegratedMotion integrate_under_pulse(const Oscillator& oscillator,
                                                     const Pulse& pulse, double size,
                                                     double tolerance);

}  // namespace stillpoint::design
