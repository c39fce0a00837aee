// SPDX-License-Identifier: MIT
#include <stillpoint/report/report.hpp>

#include <fmt/format.h>

#include <iterator>

namespace stillpoint::report {

PhysicalState physical_state(const State& state, const design::Scales& scales) {
  const auto& [tau, x, v] = state;
  return {tau, x, v, tau * scales.time_s, x * scales.length_m, v * scales.velocity_m_per_s};
}

std::string trajectory_csv(const std::vector<State>& states,
                           const std::optional<design::PhysicalInput>& physical) {
  std::string text = physical ? "tau,x,v,t_s,x_m,v_m_per_s\n" : "tau,x,v\n";
  auto end = std::back_inserter(text);
  for (const State& state : states) {
    fmt::format_to(end, "{},{},{}", state.tau, state.x, state.v);
    if (physical) {
      const PhysicalState now = physical_state(state, physical->scales);
      fmt::format_to(end, ",{},{},{}", now.t_s, now.x_m, now.v_m_per_s);
    }
    text += '\n';
  }
  return text;
}

}  // namespace stillpoint::report
