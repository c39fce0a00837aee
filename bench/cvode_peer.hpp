// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/peers/scene.hpp>

namespace stillpoint::bench {

/// SUNDIALS CVODE 6: Adams with fixed-point iteration, as its manual advises for
/// problems that are not stiff; `tolerance` is absolute and relative. CVodeRootInit finds events in
/// the given directions; CVodeReInit after each; stop times at kinks.
[[nodiscard]] peers::Result cvode_adams(const peers::Scene& scene, double tolerance);

}  // namespace stillpoint::bench
