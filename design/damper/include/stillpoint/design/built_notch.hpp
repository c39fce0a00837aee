// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/design.hpp>

namespace stillpoint::design {

/// A design with the notch that will be built, of finite width: docs/notches.md.
struct BuiltNotch {
  double width{0};
  double friction{0};  ///< within |x| < width / 2: f + delta / width
  ForcedResponse response;
};

/// The motion that the design was made for, and with a pulse that under the pulse itself. Throws
/// InputError for a wrong width, TooManyHalfCycles.
[[nodiscard]] BuiltNotch built_notch(const DesignRequest& request, const DesignPoint& point,
                                     double width);

}  // namespace stillpoint::design
