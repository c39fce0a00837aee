// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/design/physical.hpp>

#include <optional>

namespace stillpoint::design {

/// What a load can do to a mass without friction.
struct LoadReach {
  double reach_m;  ///< largest displacement from rest; of a harmonic, away from resonance
  /// What it adds to the speed of a passage at most. (v, p x) turns at a constant distance from
  /// the origin, to which the load adds no more than the integral of |W|; friction and the notch
  /// only take from it.
  double speed_m_per_s;
  bool pulse;
};

/// Up to `t_end`, with the spring p.
[[nodiscard]] LoadReach load_reach(const Excitation& load, double p,
                                   const std::optional<double>& t_end, const Scales& scales);

}  // namespace stillpoint::design
