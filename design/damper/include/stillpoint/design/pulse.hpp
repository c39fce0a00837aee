// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/pulse_speed.hpp>
#include <stillpoint/design/problem.hpp>

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace stillpoint::design {

/// The pulses that act like an initial velocity. A full sine does not: it leaves none.
using Pulse = std::variant<HalfSine, Rectangle>;

/// A problem whose initial velocity comes from a pulse. Friction already acts during the pulse, so
/// the velocity depends on f and falls with it: docs/forced.md section 8.
struct PulseProblem {
  Pulse pulse;
  double p{1};
  double beta{1};
  Criterion criterion{Criterion::published};
};

/// Throws InputError, naming the field, unless k > 0, lambda >= p (a longer pulse is not an
/// impulse), there is no acceleration_max, and the problem of the velocity left without friction is
/// valid (problem.hpp).
void require_valid(const PulseProblem& problem, const Limits& limits = {});

[[nodiscard]] double peak_load(const Pulse& pulse);          ///< k
[[nodiscard]] double angular_frequency(const Pulse& pulse);  ///< lambda
[[nodiscard]] std::string_view name(const Pulse& pulse);     ///< "half-sine" or "rectangle"
[[nodiscard]] Excitation excitation(const Pulse& pulse);
/// Of core, empty where the mass never moves.
[[nodiscard]] std::optional<EquivalentStart> equivalent_start(const Pulse& pulse, double f);

/// The problem with the velocity that the pulse leaves under friction f; 0 where f >= k.
[[nodiscard]] Problem problem_at(const PulseProblem& problem, double f);

/// Why a pulse does not act like an initial velocity.
enum class PulseWarning {
  pulse_not_short,     ///< p / lambda > 0.2
  friction_not_small,  ///< f / k > 0.2
};

/// "pulse_not_short" and so on.
[[nodiscard]] std::string_view name(PulseWarning warning) noexcept;
/// The warning of that name; empty where there is none.
[[nodiscard]] std::optional<PulseWarning> parse_pulse_warning(std::string_view name) noexcept;

/// The design under its pulse, followed from rest by the exact forced motion.
struct PulseCheck {
  double shortness{0};       ///< p / lambda, the paper's eps for p = 1
  double friction_ratio{0};  ///< f / k
  EquivalentStart start;     ///< of the free motion that the design was made for
  ForcedResponse response;
  double peak_error{0};                   ///< of the free motion's peak, relative to the true one
  std::optional<double> stop_time_error;  ///< of start.tau + the free stop time, likewise
  std::vector<PulseWarning> warnings;
};

}  // namespace stillpoint::design
