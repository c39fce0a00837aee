// SPDX-License-Identifier: MIT
// What the rooms call and a page never does: only sweeps have maps.
#include <stillpoint/figures/figure.hpp>

#include <string>

namespace stillpoint::figures {

std::string map_base64(const FigureMap& map);
std::string map_base64(const FigureMap& /*map*/) {
  return {};
}

}  // namespace stillpoint::figures
