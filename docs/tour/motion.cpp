// SPDX-License-Identifier: MIT
// One motion: how it ends, and where the mass is at any instant.

#include <stillpoint/core.hpp>

#include <iostream>

int main() {
  const stillpoint::Oscillator damper{.p = 1, .f = 0.02, .delta = 0.02};
  const stillpoint::Start push{.x0 = 0, .v0 = 1};

  const stillpoint::Response motion = stillpoint::free_response(damper, push);
  std::cout << summary(motion) << "\n\n"
            << "outcome      " << name(motion.outcome) << '\n'
            << "peak         " << motion.peak_amplitude << '\n';
  if (motion.stop_time && motion.half_cycles) {  // a motion without friction has neither
    std::cout << "stop time    " << *motion.stop_time << '\n'
              << "half-cycles  " << *motion.half_cycles << '\n';
  }

  const stillpoint::Trajectory trajectory(damper, push, {});
  for (const double tau : {1.0, 10.0, 30.0}) {
    const stillpoint::State state = trajectory.at(tau);
    std::cout << "at tau " << tau << "  x = " << state.x << ", v = " << state.v << '\n';
  }
}
