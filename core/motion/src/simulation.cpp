// SPDX-License-Identifier: MIT
#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/core/trajectory.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>

namespace stillpoint {

namespace {

double ten_periods(const SimulationRequest& request) {
  constexpr double periods_of_endless_motion = 10;
  return periods_of_endless_motion * 2 * std::numbers::pi / request.oscillator.p;
}

Simulation free_simulation(const SimulationRequest& request) {
  FreeOptions options;
  options.half_cycle_limit = request.half_cycle_limit.value_or(options.half_cycle_limit);
  Simulation result;
  result.response = free_response(request.oscillator, request.start, options);
  result.half_cycles =
      first_half_cycles(request.oscillator, request.start, request.max_half_cycles);
  if (request.samples) {
    const bool ends = request.t_end || result.response.stop_time;
    const Trajectory path(request.oscillator, request.start,
                          {ends ? request.t_end : ten_periods(request)});
    result.trajectory = path.sampled(*request.samples);
  }
  return result;
}

/// The end of the run, if given; the t_end of a free motion is that of its trajectory.
std::optional<double> run_end(const SimulationRequest& request) {
  return is_forced(request) ? request.t_end : std::nullopt;
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

/// The three passes over one forced motion, or one on a surface of its own.
class ForcedSimulation {
 public:
  ForcedSimulation(const SimulationRequest& request, const std::function<bool(double)>& go_on)
      : request_(request), go_on_([this, &go_on](double tau) {
          result_.cancelled = result_.cancelled || (go_on && !go_on(tau));
          return !result_.cancelled;
        }) {}
  ForcedSimulation(const ForcedSimulation&) = delete;
  ForcedSimulation& operator=(const ForcedSimulation&) = delete;
  ForcedSimulation(ForcedSimulation&&) = delete;
  ForcedSimulation& operator=(ForcedSimulation&&) = delete;
  ~ForcedSimulation() = default;

  Simulation operator()() {
    const std::optional<double> end = run_end(request_);
    if (end) {
      trace(*end);  // first: if the motion is too long for it, nothing else is computed
    }
    if (!result_.cancelled) {
      respond();
    }
    if (!result_.cancelled && !end) {
      trace(request_.t_end.value_or(*result_.horizon));
    }
    if (!result_.cancelled) {
      result_.half_cycles =
          forced_half_cycles(request_.oscillator, request_.start, request_.excitation,
                             *result_.horizon, request_.max_half_cycles, go_on_, request_.surface);
    }
    return std::move(result_);
  }

 private:
  void respond() {
    ForcedOptions options;
    options.t_end = run_end(request_);
    options.half_cycle_limit = request_.half_cycle_limit;
    options.go_on = go_on_;
    result_.forced = forced_response(request_.oscillator, request_.start, request_.excitation,
                                     options, request_.surface);
    result_.response = static_cast<const Response&>(*result_.forced);
    if (!result_.cancelled) {
      result_.horizon = horizon_of(request_, *result_.forced);
    }
  }

  void trace(double horizon) {
    if (request_.samples) {
      ForcedTrajectoryOptions options;
      options.horizon = horizon;
      options.to_rest = !request_.t_end;
      options.go_on = go_on_;
      const ForcedTrajectory path(request_.oscillator, request_.start, request_.excitation, options,
                                  request_.surface);
      result_.trajectory = path.sampled(*request_.samples);
    }
  }

  const SimulationRequest& request_;
  std::function<bool(double)> go_on_;
  Simulation result_;
};

}  // namespace

bool is_forced(const SimulationRequest& request) {
  return !std::holds_alternative<NoExcitation>(request.excitation);
}

Simulation simulate(const SimulationRequest& request, const std::function<bool(double)>& go_on) {
  if (!is_forced(request) && request.surface.plain()) {
    return free_simulation(request);
  }
  Simulation result = ForcedSimulation(request, go_on)();
  if (!is_forced(request)) {
    result.forced.reset();
    result.horizon.reset();
  }
  return result;
}

}  // namespace stillpoint
