// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/pulse_speed.hpp>

#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint::design {

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
