// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::bench {

/// GSL's rk8pd (Prince and Dormand), adaptive, with `tolerance` absolute and relative. It has no
/// dense output: events are sign changes over a step, then Newton's method within the
/// bracket on shorter steps from its start.
[[nodiscard]] peers::Result gsl_rk8pd(const peers::Scene& scene, double tolerance);

}  // namespace stillpoint::bench
