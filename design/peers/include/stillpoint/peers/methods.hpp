// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

#include <cstdint>
#include <limits>
#include <optional>

namespace stillpoint::peers {

// Each gives up, Result::finished false, after an effort of `most`: a step, a look at the load of a
// mass at rest, and ten of them for an event.
inline constexpr std::int64_t usual_effort = 20'000'000;
inline constexpr std::int64_t any_effort = std::numeric_limits<std::int64_t>::max();

/// Boost.Odeint's dopri5, adaptive: the error of a step is at most `tolerance`, relative to the
/// state plus `size`. Events are sign changes over a step, bracketed on its dense output. Steps end
/// at the kinks of W.
[[nodiscard]] Result dopri5(const Scene& scene, double tolerance, const Size& size = {},
                            std::int64_t most = usual_effort);

/// The classical Runge-Kutta method with a fixed `step` in tau, shortened only to end at events and
/// kinks, but of `under_load` up to the end of a load that has one. Events are sign changes over a
/// step, then Newton's method within the bracket on shorter steps from its start.
[[nodiscard]] Result runge_kutta4(const Scene& scene, double step, std::int64_t most = usual_effort,
                                  const std::optional<double>& under_load = {});

/// The model without events: sgn v becomes tanh(v / e), dirac(x) a bump, both `width` wide as a
/// part of `size`, and dopri5 integrates it with the tolerance width / 1000. Below 3 e the mass
/// counts as at rest. It has no hold.
[[nodiscard]] Result regularised(const Scene& scene, double width, const Size& size = {},
                                 std::int64_t most = usual_effort);

/// This project's kernel with all that it computes by default: counts, peaks, times, margin. A
/// scene without excitation goes to free_response, or on a surface to forced_response, the others
/// to forced_response up to t_end.
[[nodiscard]] Result kernel(const Scene& scene);

}  // namespace stillpoint::peers
