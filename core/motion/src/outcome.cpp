// SPDX-License-Identifier: MIT
#include <stillpoint/core/outcome.hpp>

#include <cassert>

namespace stillpoint {

std::string_view name(Outcome outcome) noexcept {
  switch (outcome) {
    case Outcome::stopped_at_zero:
      return "stopped_at_zero";
    case Outcome::stopped_in_dead_zone:
      return "stopped_in_dead_zone";
    case Outcome::never_stops:
      return "never_stops";
    case Outcome::caught_at_start:
      return "caught_at_start";
    case Outcome::running:
      return "running";
  }
  assert(false && "an Outcome outside its enumeration");
  return "";
}

}  // namespace stillpoint
