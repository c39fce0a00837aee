// SPDX-License-Identifier: MIT
#include "trajectory_csv.hpp"

#include <stillpoint/core/forced_trajectory.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numbers>
#include <optional>
#include <vector>

namespace stillpoint::cli {

namespace {

constexpr double periods_of_endless_motion = 10;

double ten_periods(const SimulateInput& input) {
  return periods_of_endless_motion * 2 * std::numbers::pi / input.oscillator.p;
}

/// Empty: to the end of the motion.
std::optional<double> free_horizon(const SimulateInput& input, const Response& response) {
  return input.t_end || response.stop_time ? input.t_end : ten_periods(input);
}

bool comes_to_rest(const ForcedResponse& response) {
  return response.stop_time && *response.stop_time > 0;
}

std::string csv(const SimulateInput& input, const std::vector<State>& states) {
  std::string text = input.physical ? "tau,x,v,t_s,x_m,v_m_per_s\n" : "tau,x,v\n";
  auto end = std::back_inserter(text);
  for (const State& state : states) {
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

}  // namespace

double forced_horizon(const SimulateInput& input, const ForcedResponse& response) {
  // The end of the motion comes from the free kernel, which may round it an ulp earlier than the
  // forced one that lists what led to it. A rest under a load is the final one once that is over.
  constexpr double behind_the_end = 1 + 1e-12;
  if (input.t_end) {
    return *input.t_end;
  }
  const double lasts = duration(input.excitation->excitation).value();
  return comes_to_rest(response) ? std::max(*response.stop_time, lasts) * behind_the_end
                                 : lasts + ten_periods(input);
}

std::string free_trajectory_csv(const SimulateInput& input, const Response& response) {
  const Trajectory path(input.oscillator, input.start, {free_horizon(input, response)});
  return csv(input, path.sampled(input.samples));
}

std::string forced_trajectory_csv(const SimulateInput& input, double horizon,
                                  const std::function<bool(double)>& go_on) {
  ForcedTrajectoryOptions limits;
  limits.horizon = horizon;
  limits.to_rest = !input.t_end;
  limits.go_on = go_on;
  const ForcedTrajectory path(input.oscillator, input.start, input.excitation->excitation, limits);
  return csv(input, path.sampled(input.samples));
}

}  // namespace stillpoint::cli
