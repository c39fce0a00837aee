// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>

#include <optional>

namespace stillpoint::design {

/// What tasks limit and minimise of a motion, whatever moves the mass.
struct Figures {
  double peak{0};                     ///< largest |x|
  double acceleration{0};             ///< largest transmitted one, in g
  double jump{0};                     ///< largest of the velocity, at a notch without a width
  std::optional<double> residual{};   ///< |x| at the final rest, if there is one
  std::optional<double> stop_time{};  ///< likewise
  /// From when the notch holds the mass although the load goes on, and the load from then on.
  std::optional<double> locked{};
  std::optional<double> largest_load_while_locked{};
};

[[nodiscard]] Figures figures_of(const Response& motion);
[[nodiscard]] Figures figures_of(const ForcedResponse& motion);

}  // namespace stillpoint::design
