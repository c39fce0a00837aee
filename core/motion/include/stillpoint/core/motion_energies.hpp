// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/surface.hpp>

#include <optional>

namespace stillpoint {

/// Where the energy of a motion comes from and goes to, per unit of mass:
///   start + load = end + friction + notch + damping.
/// Each is found by itself, so that the sum is a check: docs/forced.md section 11.
struct Energies {
  double friction{0};  ///< f times the slip path, in a notch with a width too
  double notch{0};     ///< what the notch takes beyond that, a caught start included
  double damping{0};
  double load{0};       ///< the work of the load on the mass as seen from the base
  double start{0};      ///< v^2/2 + p^2 x^2/2
  double end{0};        ///< the same where the run ends
  double slip_path{0};  ///< the distance slid

  [[nodiscard]] bool operator==(const Energies&) const = default;
};

struct MotionEnergies {
  double peak_velocity{0};           ///< largest |x'|, the start included
  std::optional<Energies> energies;  ///< empty where the motion never ends

  [[nodiscard]] bool operator==(const MotionEnergies&) const = default;
};

/// Of the motion that forced_response describes or, without an excitation, free_response. Throws
/// what they throw.
[[nodiscard]] MotionEnergies motion_energies(const Oscillator& oscillator, const Start& start,
                                             const Excitation& excitation,
                                             const ForcedOptions& options = {},
                                             const Surface& surface = {});

}  // namespace stillpoint
