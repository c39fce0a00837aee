// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <cstdint>

namespace stillpoint::peers {

/// A motion to compare methods on. Inputs are those of core and must be valid; nothing is checked
/// here.
struct Scene {
  Oscillator oscillator;
  Start start;
  Excitation excitation;
  double t_end{0};  ///< tau at which the run ends, > 0 and finite; it ends before in a final rest
  Surface surface{};
};

/// The result of a method, dimensionless; the counts are defined as in core's Response.
struct Result {
  Outcome outcome{Outcome::running};  ///< `running`: followed up to end_time
  double peak{0};                     ///< largest |x|
  double end_time{0};                 ///< when the final rest began, or how far the run came
  double x{0};                        ///< at end_time
  double v{0};
  double arrival_speed{0};          ///< of the last arrival at x = 0 where a notch is
  double acceleration{0};           ///< largest transmitted: |p^2 x + s f| in motion, |W| at rest
  double relative_acceleration{0};  ///< largest |v'| at the ends of steps, of methods that know it
  std::int64_t passages{0};
  std::int64_t turns{0};
  std::int64_t sticks{0};
  std::int64_t steps{0};  ///< accepted integration steps; 0 where the method has none
  bool finished{true};    ///< false: it gave up after the allowed effort, `running`
};

/// The size of a motion, for integrators: their absolute tolerances are relative to it, so the
/// units of a scene do not matter.
struct Size {
  double length{1};
  double speed{1};
  double time{1};  ///< in which the motion changes
};

}  // namespace stillpoint::peers
