// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace stillpoint {

/// One half-cycle: from x = 0 (or the start) out to a peak and back to x = 0 (or to rest).
struct HalfCycle {
  std::int64_t index{1};                ///< 1, 2, ...
  int side{1};                          ///< sign of x during it
  double start_time{0};                 ///< tau; of a mass held from its start, of the release
  double departure_speed{0};            ///< |x'| at its start, after the notch
  double peak_time{0};                  ///< tau of the peak; start_time where it starts inwards
  double peak{0};                       ///< largest |x| of it
  double end_time{0};                   ///< tau of the arrival at x = 0, or of the rest
  double end_position{0};               ///< 0, or the signed place of a rest off x = 0
  std::optional<double> arrival_speed;  ///< |x'| at x = 0 before the notch; empty: rests off x = 0
  /// v- - v+ of the notch at its end, per mass, which the structure feels; empty where it does not
  /// end at x = 0, or where the notch has a width and is felt as an acceleration.
  std::optional<double> impulse;
  bool last{false};  ///< the motion ends with it

  [[nodiscard]] bool operator==(const HalfCycle&) const = default;
};

/// The first `most` half-cycles of a free motion. With only one friction each comes from the closed
/// form, rounded once, so the last is where free_response says. Throws InputError like
/// free_response.
[[nodiscard]] std::vector<HalfCycle> first_half_cycles(const Oscillator& oscillator,
                                                       const Start& start, std::int64_t most);

/// The first `most` half-cycles of a forced motion up to tau = t_end: from x = 0 (or the start) to
/// the next arrival at x = 0, the final rest or t_end. `peak` is the largest |x| at a turn, stick
/// or end of the half-cycle, `side` the sign of x there; peak_time is when. arrival_speed is empty
/// where the half-cycle does not end at x = 0. The run ends with the last one listed.
/// `go_on` as in ForcedOptions; if it returns false, the list holds the half-cycles so far. Throws
/// InputError as forced_response does.
[[nodiscard]] std::vector<HalfCycle> forced_half_cycles(
    const Oscillator& oscillator, const Start& start, const Excitation& excitation, double t_end,
    std::int64_t most, const std::function<bool(double)>& go_on = {}, const Surface& surface = {});

}  // namespace stillpoint
