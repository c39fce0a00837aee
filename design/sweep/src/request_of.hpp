// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/suite_task.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>
#include <functional>
#include <optional>

namespace stillpoint::sweep {

/// Throws InputError unless it is a whole number from 1 to design::most_arrivals.
[[nodiscard]] std::int64_t whole_arrivals(double value);

/// The task of an entry of a sweep over designs; `at` gives the values of the inputs that the sweep
/// has. Throws InputError for wrong arrivals.
[[nodiscard]] design::DesignRequest request_of(const SweepSpec& spec,
                                               const std::function<double(Quantity)>& at);

/// The same for a mass that closed forms do not know: one with damping or a breakaway friction.
/// Empty for any other.
[[nodiscard]] std::optional<design::RecordDesignRequest> simulated_request(
    const SweepSpec& spec, const std::function<double(Quantity)>& at);

/// The record of an entry of a sweep over several, scaled. Throws InputError for a scale of 0.
[[nodiscard]] Excitation load_of(const SweepSpec& spec, const std::function<double(Quantity)>& at);

struct MotionRequest {
  Oscillator oscillator;
  Start start;
  Surface surface;
};

/// The same of a sweep over motions.
[[nodiscard]] MotionRequest motion_of(const SweepSpec& spec,
                                      const std::function<double(Quantity)>& at);

}  // namespace stillpoint::sweep
