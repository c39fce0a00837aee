// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/half_cycle_walk.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>
#include <functional>
#include <vector>

namespace stillpoint {

/// The first `most` half-cycles of a forced motion up to tau = t_end: from x = 0 (or the start) to
/// the next arrival at x = 0, the final rest or t_end. `peak` is the largest |x| at a turn, stick
/// or end of the half-cycle, `side` the sign of x there; peak_time is when. arrival_speed is empty
/// where the half-cycle does not end at x = 0. The run ends with the last one that is listed.
/// `go_on` as in ForcedOptions; if it returns false, the list holds the half-cycles so far. Throws
/// InputError as forced_response does.
[[nodiscard]] std::vector<HalfCycle> forced_half_cycles(
    const Oscillator& oscillator, const Start& start, const Excitation& excitation, double t_end,
    std::int64_t most, const std::function<bool(double)>& go_on = {}, const Surface& surface = {});

}  // namespace stillpoint
