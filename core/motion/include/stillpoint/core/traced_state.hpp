// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <vector>

namespace stillpoint {

/// A state with what acts on the mass there, all in g: docs/forced.md section 11.
struct TracedState {
  double tau{0};
  double x{0};
  double v{0};
  double w{0};                      ///< the load W
  double absolute_acceleration{0};  ///< x'' + W, which the structure feels
  double friction{0};  ///< > 0 against v > 0, that of a notch with a width included; at rest what
                       ///< holds the mass, a notch without width included
};

/// Of the states of one motion from its start on, in order of time.
[[nodiscard]] std::vector<TracedState> traced(const Oscillator& oscillator, const Surface& surface,
                                              const Excitation& excitation,
                                              const std::vector<State>& states);

}  // namespace stillpoint
