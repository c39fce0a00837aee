// SPDX-License-Identifier: MIT
#include "dopri5.hpp"

#include <stillpoint/peers/methods.hpp>

namespace stillpoint::peers {

Result dopri5(const Scene& scene, double tolerance, const Size& size, std::int64_t most) {
  Dopri5 method(tolerance, size);
  return run_events(scene, method, most);
}

}  // namespace stillpoint::peers
