// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::peers {

/// Boost.Odeint's dopri5, adaptive, absolute and relative error a step at most `tolerance`. Events
/// are sign changes over a step, bracketed on its dense output. Steps end at the kinks of W.
[[nodiscard]] Result dopri5(const Scene& scene, double tolerance);

/// The classical Runge-Kutta method with a fixed `step` in tau, shortened only to end at events and
/// kinks. Events are sign changes over a step, then Newton's method within the bracket on
/// shorter steps from its start.
[[nodiscard]] Result runge_kutta4(const Scene& scene, double step);

/// The model without events: sgn v becomes tanh(v / width), dirac(x) a bump of that width, and
/// dopri5 integrates it with the tolerance width / 1000. Below 3 width the mass counts as at rest.
/// Gives up after `most_steps`, `running`.
[[nodiscard]] Result regularised(const Scene& scene, double width,
                                 std::int64_t most_steps = 20'000'000);

}  // namespace stillpoint::peers
