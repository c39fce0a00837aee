// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/pulse.hpp>

#include "check/runge_kutta.hpp"

namespace stillpoint::design {

/// The motion from rest under a pulse up to its first arrival at x = 0 or its rest elsewhere, by
/// adaptive Runge-Kutta as integrate_free_motion. It shares only the rules with the kernel. A
/// passage ends it, with half_cycles = 2 and not stopped. `tolerance` is the integrator's,
/// relative, and absolute of `size`, the peak to expect.
[[nodiscard]] IntegratedMotion integrate_under_pulse(const Oscillator& oscillator,
                                                     const Pulse& pulse, double size,
                                                     double tolerance);

}  // namespace stillpoint::design
