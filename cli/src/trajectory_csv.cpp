// SPDX-License-Identifier: MIT
#include "trajectory_csv.hpp"

#include <stillpoint/core/trajectory.hpp>

#include <fmt/format.h>

#include <iterator>
#include <numbers>
#include <optional>

namespace stillpoint::cli {

namespace {

/// Empty: to the end of the motion.
std::optional<double> horizon(const SimulateInput& input, const Response& response) {
  constexpr double periods_of_endless_motion = 10;
  if (input.t_end || response.stop_time) {
    return input.t_end;
  }
  return periods_of_endless_motion * 2 * std::numbers::pi / input.oscillator.p;
}

}  // namespace

std::string trajectory_csv(const SimulateInput& input, const Response& response) {
  const Trajectory trajectory(input.oscillator, input.start, {horizon(input, response)});
  std::string text = input.physical ? "tau,x,v,t_s,x_m,v_m_per_s\n" : "tau,x,v\n";
  auto end = std::back_inserter(text);
  for (const State& state : trajectory.sampled(input.samples)) {
    fmt::format_to(end, "{},{},{}", state.tau, state.x, state.v);
    if (input.physical) {
      const design::Scales& scales = input.physical->scales;
      fmt::format_to(end, ",{},{},{}", state.tau * scales.time_s, state.x * scales.length_m,
                     state.v * scales.velocity_m_per_s);
    }
    text += '\n';
  }
  return text;
}

}  // namespace stillpoint::cli
