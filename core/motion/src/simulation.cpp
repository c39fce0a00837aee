// SPDX-License-Identifier: MIT
#include "forced_response_of_valid.hpp"
#include "motion_watchers.hpp"

#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace stillpoint {

namespace {

double ten_periods(const SimulationRequest& request) {
  constexpr double periods_of_endless_motion = 10;
  return periods_of_endless_motion * 2 * std::numbers::pi / request.oscillator.p;
}

/// The end of the run, if given; the t_end of a free motion is that of its trajectory.
std::optional<double> run_end(const SimulationRequest& request) {
  return is_forced(request) ? request.t_end : std::nullopt;
}

ForcedOptions options_of(const SimulationRequest& request,
                         const std::function<bool(double)>& go_on) {
  return {.t_end = run_end(request), .half_cycle_limit = request.half_cycle_limit, .go_on = go_on};
}

std::vector<TracedState> traced(const SimulationRequest& request, const std::vector<State>& path) {
  return traced(request.oscillator, request.surface, request.excitation, path);
}

FreeOptions options_of(const SimulationRequest& request) {
  FreeOptions options;
  options.half_cycle_limit = request.half_cycle_limit.value_or(options.half_cycle_limit);
  return options;
}

Simulation free_simulation(const SimulationRequest& request) {
  Simulation result;
  result.response = free_response(request.oscillator, request.start, options_of(request));
  if (request.energies) {
    result.energies = energies_of(request);
  }
  result.half_cycles =
      first_half_cycles(request.oscillator, request.start, request.max_half_cycles);
  if (request.samples) {
    const bool ends = request.t_end || result.response.stop_time;
    const Trajectory path(request.oscillator, request.start,
                          {ends ? request.t_end : ten_periods(request)});
    result.trajectory = traced(request, path.sampled(*request.samples));
  }
  return result;
}

/// Until the rest is known to be final; if the motion never stops, ten periods more.
double horizon_of(const SimulationRequest& request, const ForcedResponse& response) {
  // The end of the motion comes from the free kernel, which may round it an ulp earlier than the
  // forced one that lists the events before it. A rest under a load is final once the load is over.
  constexpr double behind_the_end = 1 + 1e-12;
  if (const auto end = run_end(request)) {
    return *end;
  }
  const double lasts = duration(request.excitation).value();
  const double stop_time = response.stop_time.value_or(0);
  const double horizon =
      stop_time > 0 ? std::max(stop_time, lasts) * behind_the_end : lasts + ten_periods(request);
  const double latest = largest_phase / request.oscillator.p;
  if (horizon > latest) {
    throw InputError::missing("t_end",
                              fmt::format("the motion lasts until tau = {:.6g}, but can be "
                                          "followed only to {:.6g}: give an earlier end",
                                          horizon, latest));
  }
  return horizon;
}

/// One run of a forced motion, or of one on a surface of its own.
Simulation simulate_forced(const SimulationRequest& request,
                           const std::function<bool(double)>& go_on) {
  WatchedOptions wanted{options_of(request, go_on)};
  require_valid(wanted);
  const auto energies = energy_watcher(request.oscillator, request.surface, request.start, wanted);
  const auto half_cycles =
      half_cycle_watcher(request.oscillator, request.surface, request.max_half_cycles);
  const auto path =
      path_watcher(request.oscillator, ForcedTrajectoryOptions().pieces, !request.t_end);
  wanted.response = true;
  if (request.energies) {
    wanted.to_end.push_back(energies.get());
  }
  if (request.max_half_cycles > 0) {
    wanted.listing.push_back(half_cycles.get());
  }
  if (request.samples) {
    wanted.listing.push_back(path.get());
  }
  wanted.horizon = [&](const MotionWatcher& watcher, const ForcedResponse& response) {
    const double horizon = horizon_of(request, response);
    return &watcher == path.get() ? request.t_end.value_or(horizon) : horizon;
  };
  Simulation result;
  result.forced = watched_motion(request.oscillator, request.surface, request.start,
                                 request.excitation, wanted);
  result.response = static_cast<const Response&>(*result.forced);
  result.cancelled = result.forced->cancelled;
  if (!result.cancelled) {
    result.horizon = horizon_of(request, *result.forced);
    result.energies = energies->found();
    result.half_cycles = half_cycles->found();
    if (request.samples) {
      result.trajectory = traced(request, path->found().sampled(*request.samples));
    }
  }
  return result;
}

}  // namespace

bool is_forced(const SimulationRequest& request) {
  return !std::holds_alternative<NoExcitation>(request.excitation);
}

bool has_closed_form(const SimulationRequest& request) {
  return !is_forced(request) && paper_motion(request.oscillator, request.surface);
}

MotionEnergies energies_of(const SimulationRequest& request,
                           const std::function<bool(double)>& go_on) {
  return motion_energies(request.oscillator, request.start, request.excitation,
                         options_of(request, go_on), request.surface);
}

Simulation simulate(const SimulationRequest& request, const std::function<bool(double)>& go_on) {
  if (has_closed_form(request)) {
    return free_simulation(request);
  }
  Simulation result = simulate_forced(request, go_on);
  if (!is_forced(request)) {
    result.forced.reset();
    result.horizon.reset();
    if (request.surface.plain() && !result.cancelled) {  // the bits of a batch
      result.response = free_response(request.oscillator, request.start, options_of(request));
    }
  }
  return result;
}

}  // namespace stillpoint
