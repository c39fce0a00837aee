// SPDX-License-Identifier: MIT
#pragma once

// What the decision margin of a load cannot tell: how the motion ends if the damper is slightly
// off.

#include <stillpoint/core/interval.hpp>
#include <stillpoint/core/simulation.hpp>

#include <optional>

namespace stillpoint {

/// The ends of a motion and of four others: with f, that of the zones too, and Delta off either
/// way.
struct NearbyEnds {
  std::optional<Interval> rests{};  ///< where they rest; empty if the motion does not
  bool rest_differs{false};         ///< some come to rest, others do not
  bool lock_differs{false};
};

/// 1 % off: no damper is built more accurately. Empty for a motion that takes longer to follow than
/// anyone waits for a note. Throws as forced_response does.
[[nodiscard]] std::optional<NearbyEnds> nearby_ends(const SimulationRequest& request,
                                                    const Simulation& motion);

}  // namespace stillpoint
