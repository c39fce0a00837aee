// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace stillpoint {

/// forced_response for input that has been checked.
ForcedResponse forced_response_of_valid(const Oscillator& oscillator, const Start& start,
                                        const Excitation& excitation, const ForcedOptions& options,
                                        const Surface& surface);

/// The same on a surface that is not the paper's.
ForcedResponse zoned_response_of_valid(const Oscillator& oscillator, const Start& start,
                                       const Excitation& excitation, const ForcedOptions& options,
                                       const Surface& surface);

/// Checks scene after scene under one excitation. A record is long, and its check depends on the
/// oscillator only through p, which it allows between two bounds. So every p between two allowed
/// ones is allowed.
class SceneCheck {
 public:
  SceneCheck(const Excitation& excitation, const std::optional<double>& t_end)
      : excitation_(excitation), t_end_(t_end) {}

  void require(const Oscillator& oscillator, const Start& start) {
    if (least_p_ <= oscillator.p && oscillator.p <= most_p_) {
      require_valid(oscillator, start);
      return;
    }
    require_valid(oscillator, start, excitation_, t_end_);
    least_p_ = std::min(least_p_, oscillator.p);
    most_p_ = std::max(most_p_, oscillator.p);
  }

 private:
  const Excitation& excitation_;
  const std::optional<double>& t_end_;
  double least_p_{std::numeric_limits<double>::infinity()};
  double most_p_{0};
};

}  // namespace stillpoint
