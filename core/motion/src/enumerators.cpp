// SPDX-License-Identifier: MIT
#include <stillpoint/core/names.hpp>
#include <stillpoint/core/state.hpp>

namespace stillpoint {

std::span<const Named<Outcome>> enumerators(Outcome) noexcept {
  static constexpr auto rows =
      std::to_array<Named<Outcome>>({{Outcome::stopped_at_zero, "stopped_at_zero"},
                                     {Outcome::stopped_in_dead_zone, "stopped_in_dead_zone"},
                                     {Outcome::stopped_in_notch, "stopped_in_notch"},
                                     {Outcome::never_stops, "never_stops"},
                                     {Outcome::caught_at_start, "caught_at_start"},
                                     {Outcome::running, "running"}});
  return rows;
}

}  // namespace stillpoint
