// SPDX-License-Identifier: MIT
#include <stillpoint/peers/methods.hpp>

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>

#include <cmath>
#include <optional>
#include <variant>

namespace stillpoint::peers {

namespace {

Result common(const Response& response) {
  Result result;
  result.outcome = response.outcome;
  result.peak = response.peak_amplitude;
  result.passages = std::llround(response.zero_passages.value());
  result.turns = std::llround(response.turning_points.value());
  return result;
}

}  // namespace

Result kernel(const Scene& scene) {
  const bool free = std::holds_alternative<NoExcitation>(scene.excitation);
  if (free && scene.surface.plain()) {
    const Response response = free_response(scene.oscillator, scene.start);
    Result result = common(response);
    result.end_time = response.stop_time.value();
    result.x = response.stop_position.value();
    return result;
  }
  const auto t_end = free ? std::nullopt : std::optional(scene.t_end);
  const ForcedResponse response = forced_response(scene.oscillator, scene.start, scene.excitation,
                                                  {.t_end = t_end}, scene.surface);
  Result result = common(response);
  result.end_time = response.end_time.value();
  result.x = response.final_position.value();
  result.v = response.final_velocity.value();
  result.sticks = std::llround(response.sticks);
  return result;
}

}  // namespace stillpoint::peers
