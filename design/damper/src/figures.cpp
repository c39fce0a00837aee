// SPDX-License-Identifier: MIT
#include <stillpoint/design/figures.hpp>

#include <cmath>

namespace stillpoint::design {

Figures figures_of(const Response& motion) {
  Figures figures{motion.peak_amplitude, motion.peak_absolute_acceleration, motion.jump};
  if (motion.stop_position) {
    figures.residual = std::abs(*motion.stop_position);
  }
  figures.stop_time = motion.stop_time;
  return figures;
}

Figures figures_of(const ForcedResponse& motion) {
  Figures figures = figures_of(static_cast<const Response&>(motion));
  figures.locked = motion.locked_from;
  figures.largest_load_while_locked = motion.largest_load_while_locked;
  return figures;
}

}  // namespace stillpoint::design
