// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint {

/// Where a motion is: x and v = x' at tau.
struct State {
  double tau{0};
  double x{0};
  double v{0};
};

}  // namespace stillpoint
