// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/design.hpp>

#include <optional>

namespace stillpoint::design {

/// The notch that will be built, if it is not the paper's: docs/notches.md.
struct NotchShape {
  std::optional<double> width{};
  std::optional<double> hold{};  ///< of one without a width
};

/// A design with that notch.
struct BuiltNotch {
  NotchShape shape;
  std::optional<double> friction{};  ///< within |x| < width / 2: f + delta / width
  ForcedResponse response;
  bool changes_nothing{false};  ///< compared with the same motion with the paper's notch
};

/// The motion that the design was made for; with a pulse, the motion under the pulse itself. Throws
/// InputError for a wrong shape, TooManyHalfCycles.
[[nodiscard]] BuiltNotch built_notch(const DesignRequest& request, const DesignPoint& point,
                                     const NotchShape& shape);

}  // namespace stillpoint::design
