// SPDX-License-Identifier: MIT
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>

#include <fmt/format.h>

namespace stillpoint {

namespace {

std::string ending(const Response& response) {
  switch (response.outcome) {
    case Outcome::stopped_at_zero:
    case Outcome::stopped_in_dead_zone:
    case Outcome::stopped_in_notch:
      return fmt::format("{} at x = {:.6g}", response.half_cycles == 0 ? "stays at rest" : "stops",
                         response.stop_position.value_or(0));
    case Outcome::never_stops:
      return "never stops (no friction where it moves)";
    case Outcome::caught_at_start:
      return "never leaves x = 0 (held by the point friction)";
    case Outcome::running:
      return "goes on";
  }
  return {};
}

std::string after(const std::optional<double>& half_cycles) {
  return half_cycles ? fmt::format(" after {:.15g} half-cycle{}", *half_cycles,
                                   *half_cycles == 1 ? "" : "s")
                     : std::string();
}

std::string at(const std::optional<double>& tau) {
  return tau ? fmt::format(" at tau = {:.6g}", *tau) : std::string();
}

std::string peak(const Response& response) {
  return fmt::format(", peak {:.6g}", response.peak_amplitude);
}

}  // namespace

std::string summary(const Response& response) {
  if (response.half_cycles == 0) {
    return ending(response);
  }
  return ending(response) + at(response.stop_time) + after(response.half_cycles) + peak(response);
}

std::string summary(const ForcedResponse& response) {
  if (response.outcome != Outcome::running || !response.final_position) {
    return summary(static_cast<const Response&>(response));
  }
  return fmt::format("{}{} (x = {:.6g}, v = {:.6g}){}{}",
                     response.cancelled ? "cut short" : ending(response), at(response.end_time),
                     *response.final_position, *response.final_velocity,
                     after(response.half_cycles), peak(response));
}

}  // namespace stillpoint
