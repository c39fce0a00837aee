// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>

namespace stillpoint {

/// Its limit of half-cycles.
void require_valid(const ForcedOptions& options);

/// forced_response for input that has been checked.
ForcedResponse forced_response_of_valid(const Oscillator& oscillator, const Start& start,
                                        const Excitation& excitation, const ForcedOptions& options,
                                        const Surface& surface);

/// The same on a surface that is not the paper's.
ForcedResponse zoned_response_of_valid(const Oscillator& oscillator, const Start& start,
                                       const Excitation& excitation, const ForcedOptions& options,
                                       const Surface& surface);

}  // namespace stillpoint
