// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::bench {

/// SUNDIALS CVODE 6: Adams with fixed-point iteration, as its manual advises where nothing is
/// stiff; `tolerance` absolute and relative. Events by CVodeRootInit, with the directions told;
/// CVodeReInit after each, stop times at kinks.
[[nodiscard]] peers::Result cvode_adams(const peers::Scene& scene, double tolerance);

}  // namespace stillpoint::bench
