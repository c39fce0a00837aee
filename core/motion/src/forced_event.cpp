// SPDX-License-Identifier: MIT
#include <stillpoint/core/forced_event.hpp>

#include <cassert>

namespace stillpoint {

std::string_view name(ForcedEventKind kind) noexcept {
  switch (kind) {
    case ForcedEventKind::start:
      return "start";
    case ForcedEventKind::arrival:
      return "arrival";
    case ForcedEventKind::passage:
      return "passage";
    case ForcedEventKind::turn:
      return "turn";
    case ForcedEventKind::excitation_end:
      return "excitation_end";
    case ForcedEventKind::stick:
      return "stick";
    case ForcedEventKind::release:
      return "release";
    case ForcedEventKind::rest:
      return "rest";
    case ForcedEventKind::end:
      return "end";
  }
  assert(false && "a ForcedEventKind outside its enumeration");
  return "";
}

}  // namespace stillpoint
