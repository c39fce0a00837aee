// SPDX-License-Identifier: MIT
#include "dopri5.hpp"

#include <stillpoint/peers/methods.hpp>

namespace stillpoint::peers {

Result dopri5(const Scene& scene, double tolerance) {
  Dopri5 method(tolerance);
  return run_events(scene, method);
}

}  // namespace stillpoint::peers
