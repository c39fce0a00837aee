// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace stillpoint::peers {

using State = std::array<double, 2>;  // x, v

/// x' = v, v' = -W(t) - p^2 x - s f: what an integrator integrates while v keeps its sign s.
template <class Load>
struct Motion {
  const Load& load;
  double stiffness;  // p^2
  double direction;  // s
  double friction;   // s f

  void operator()(const State& now, State& rate, double t) const {
    rate = {now[1], -load(t) - stiffness * now[0] - friction};
  }
};

/// The event that an integrator with its own event finder found at the end of a step.
enum class Located { nothing, turn, arrival };

struct Step {
  double from{0};
  double to{0};
  Located event{Located::nothing};
};

}  // namespace stillpoint::peers
