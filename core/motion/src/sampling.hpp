// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/state.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stillpoint {

/// `samples` >= 2 evenly spaced instants of [0, path.horizon()] and every event of the path, in
/// order of time; only the events if the horizon is 0. An event that falls on an instant replaces
/// it.
template <class Path>
std::vector<State> sampled_states(const Path& path, std::int64_t samples) {
  require_within("samples", static_cast<double>(samples), 2, 1e9);
  std::vector<State> states;
  states.reserve(static_cast<std::size_t>(samples) + path.events().size());
  const double horizon = path.horizon();
  if (horizon == 0) {
    for (const auto& event : path.events()) {
      states.push_back(event.state);
    }
    return states;
  }
  auto event = path.events().begin();
  for (std::int64_t i = 0; i < samples; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(samples - 1);
    const double tau = horizon * fraction;
    bool on_event = false;
    for (; event != path.events().end() && event->state.tau <= tau; ++event) {
      on_event = event->state.tau == tau;
      states.push_back(event->state);
    }
    if (!on_event) {
      states.push_back(path.at(tau));
    }
  }
  return states;
}

}  // namespace stillpoint
