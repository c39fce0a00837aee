// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

namespace stillpoint::design {

/// What gives the lambda of a wave in hertz or seconds.
enum class WaveClock {
  frequency,  ///< of its sine
  duration,   ///< of a pulse
};

/// tau is the time over `time_s`; `angle` is lambda times the duration of the pulse.
[[nodiscard]] constexpr double lambda_of(WaveClock clock, double value, double angle,
                                         double time_s) {
  return clock == WaveClock::duration ? angle * time_s / value
                                      : 2 * std::numbers::pi * value * time_s;
}

/// The value that gives this lambda.
[[nodiscard]] constexpr double value_of(WaveClock clock, double lambda, double angle,
                                        double time_s) {
  return clock == WaveClock::duration ? angle * time_s / lambda
                                      : lambda / (2 * std::numbers::pi * time_s);
}

}  // namespace stillpoint::design
