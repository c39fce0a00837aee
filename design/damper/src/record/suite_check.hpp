// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>
#include <stillpoint/design/suite_task.hpp>

namespace stillpoint::design {

/// The rules of docs/forced.md section 1 and docs/notches.md section 2 around pieces by the
/// classical Runge-Kutta method, whose steps are at most 1/2000 of 1/p and end at the samples;
/// events are bisected on a step. From rest at x = 0, to the rest unless that takes too many
/// pieces; the margin is not known. Shares no code with the kernel.
[[nodiscard]] SuiteFigures integrate_record_motion(const Oscillator& oscillator,
                                                   const Surface& surface, const Record& record);

}  // namespace stillpoint::design
