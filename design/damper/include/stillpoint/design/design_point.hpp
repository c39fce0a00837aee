// SPDX-License-Identifier: MIT
#pragma once

namespace stillpoint::design {

/// A damper and how far it may be off.
struct DesignPoint {
  double f{0};
  double delta{0};
  double tolerance{0};  ///< the largest R that it allows
};

}  // namespace stillpoint::design
