// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/problem.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// What engineers want to know about an isolator, for a free motion from x = 0 with the peak A;
/// dimensionless: forces over the weight, energies over m g H. docs/theory.md section 11. What does
/// not exist (without friction, without a stop at x = 0) is empty, as is what a double cannot hold.
struct Practice {
  std::optional<double> secant_stiffness;    ///< (f + p^2 A)/A; p^2 is the spring's
  std::optional<double> equivalent_damping;  ///< of a full cycle of amplitude A, (43), at most 1
  double base_shear{0};                      ///< f + p^2 A, which is S
  double restoring{0};                       ///< p^2 A
  std::optional<double> energy_ratio;        ///< E_s/E_h = p^2 A/(2f), EN 15129
  std::optional<double> residual_ratio;      ///< d/d_rm = p^2 A/f, EN 1998-2
  /// Per mass, a speed: the arrival that stops at x = 0, and the largest of all passages and that.
  std::optional<double> impulse_at_stop;
  std::optional<double> impulse_largest;
  /// Of each passage and of the stop at x = 0, in turn; at most the last 1000. Not of several
  /// motions.
  std::optional<std::vector<double>> impulses;
  double notch_capacity{0};          ///< Delta, the energy that a whole passage takes
  std::optional<double> notch_used;  ///< energy of the arrival that stops, over the capacity
  /// The least width with which the mass feels no more inside the notch than the limit that was
  /// asked for. Under a load, and for a rest before the first arrival, it is one that is enough.
  std::optional<double> notch_width_min;
};

/// A full cycle between plus and minus a peak, as of other isolators: docs/theory.md (43), (74).
struct FullCycle {
  double secant_stiffness{0};  ///< (f + p^2 A)/A
  double energy{0};            ///< that it takes, with both of its passages through the notch
  std::optional<double> equivalent_damping{};  ///< at most 1
};
/// Empty without a peak, and if a double cannot hold the stiffness.
[[nodiscard]] std::optional<FullCycle> full_cycle(const Oscillator& oscillator, double peak,
                                                  const std::optional<double>& notch_width = {});

/// For a motion with that response. Empty if nothing moves. A hit leaves the notch freely; a load,
/// of which `load` is the largest, must move the mass out of its notch from rest.
[[nodiscard]] std::optional<Practice> practice(const Oscillator& oscillator,
                                               const Response& response,
                                               const std::optional<double>& acceleration_max,
                                               const std::optional<double>& load = {});

/// Of a motion after a hit, from x = 0 without a load, with the paper's notch; else empty.
[[nodiscard]] std::optional<Practice> practice(const SimulationRequest& request,
                                               const Simulation& motion);

/// Of a free motion with that response: the impulse of each passage and of the stop at x = 0, in
/// turn; at most the last 1000.
[[nodiscard]] std::vector<double> impulses(const Oscillator& oscillator, const Response& response);

/// Each line as the worst of the hits and springs at the ends of the ranges; the secant stiffness
/// is that of the largest base shear. Where the paper's notch catches the weakest hits, the width
/// is enough for them too: the notch acts on them from the start.
[[nodiscard]] std::optional<Practice> worst_practice(const Problem& problem, const Limits& limits,
                                                     double f, double delta);

/// f + Delta/w + p^2 w/2, the most that the mass feels inside a notch of width w > 0: friction and,
/// at the edge by which it leaves, the spring.
[[nodiscard]] double notch_acceleration(double f, double delta, double width, double p);
/// The least width that keeps that at or below `limit`; empty if none does.
[[nodiscard]] std::optional<double> least_notch_width(double f, double delta, double limit,
                                                      double p);
/// The same if a load of up to `load` must move the mass from rest: wider than Delta/(load - f).
[[nodiscard]] std::optional<double> least_notch_width_from_rest(double f, double delta,
                                                                double limit, double p,
                                                                double load);

}  // namespace stillpoint::design
