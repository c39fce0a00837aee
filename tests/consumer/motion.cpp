// SPDX-License-Identifier: MIT
// A user of core alone: its one header, with nothing before it.

#include <stillpoint/core.hpp>

std::string line() {
  return summary(stillpoint::free_response({.p = 1, .f = 0.02, .delta = 0.02}, {.x0 = 0, .v0 = 1}));
}
