// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::peers {

/// A number with about 32 digits: the closest double `near` and the difference `rest`.
struct Wide {
  double near{0};
  double rest{0};

  /// The error of `value`, with digits left even if both agree to the last bit.
  [[nodiscard]] double error_of(double value) const {
    const double off = (value - near) - rest;
    return off < 0 ? -off : off;
  }
};

/// The motion by the rules of the kernel in 50 digits.
struct ExactResult {
  Result rounded;  ///< steps 0
  Wide peak;
  Wide end_time;
  Wide x;
  Wide v;
};

/// A free scene (NoExcitation) to its rest, for any t_end; a forced one to t_end or its rest.
/// Throws TooManyHalfCycles where a free one may have more than `most_half_cycles`. A motion that
/// never stops makes no sense here: there must be some friction.
[[nodiscard]] ExactResult exact(const Scene& scene, double most_half_cycles);

}  // namespace stillpoint::peers
