// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/sweep/spec.hpp>

#include <cstdint>
#include <functional>

namespace stillpoint::sweep {

/// Throws InputError unless it is a whole number from 1 to design::most_arrivals.
[[nodiscard]] std::int64_t whole_arrivals(double value);

/// The design problem of an entry; `at` gives the values of the inputs that the sweep has. Throws
/// InputError for wrong arrivals.
[[nodiscard]] design::Problem problem_of(const SweepSpec& spec,
                                         const std::function<double(Quantity)>& at);

}  // namespace stillpoint::sweep
