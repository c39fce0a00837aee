// SPDX-License-Identifier: MIT
#include "damped_free.hpp"
#include "forced_response_of_valid.hpp"
#include "kernel/free_run.hpp"
#include "kernel/margin_keeper.hpp"
#include "kernel/phase_clock.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <cassert>
#include <cmath>
#include <optional>

namespace stillpoint {

namespace {

Response metrics(const FreeRun<double>& run, double p) {
  Response response;
  response.outcome = run.outcome;
  response.stops_at_zero = run.outcome == Outcome::stopped_at_zero;
  response.peak_amplitude = run.farthest / p;
  response.peak_acceleration = response.peak_absolute_acceleration = run.acceleration * p;
  if (run.outcome == Outcome::never_stops) {
    return response;
  }
  response.half_cycles = run.moves ? run.passages + 1 : 0;
  response.turning_points = run.turning_points;
  response.zero_passages = run.passages;
  response.stop_position = run.rest / p;
  if (run.arrival) {
    response.arrival_speed = std::sqrt(*run.arrival);
  }
  return response;
}

double stop_time(const PhaseClock<double>& clock, const FreeRun<double>& run, double p) {
  const double time = clock.phase() / p;
  assert(!std::isnan(time));
  if (!std::isfinite(time)) {
    throw TooManyHalfCycles(run.passages + 1, largest_square * p);
  }
  return time;
}

/// Damped, or held by more than f at rest: half-cycle by half-cycle.
Response beyond_the_paper(const Oscillator& oscillator, const Start& start,
                          const FreeOptions& options) {
  if (const std::optional<DampedFree> motion =
          damped_free(oscillator, start, damped_cycle(oscillator.zeta))) {
    return damped_response(*motion, options);
  }
  Response response = forced_response_of_valid(oscillator, start, NoExcitation(),
                                               {.half_cycle_limit = options.half_cycle_limit}, {});
  if (!options.times) {
    response.stop_time.reset();
  }
  if (!options.margin) {
    response.decision_margin.reset();
  }
  return response;
}

}  // namespace

Response free_response(const Oscillator& oscillator, const Start& start,
                       const FreeOptions& options) {
  require_valid(oscillator, start);
  require_within("half_cycle_limit", options.half_cycle_limit, 1, 1e15);
  if (!oscillator.coulomb()) {
    return beyond_the_paper(oscillator, start, options);
  }
  const auto run_with = [&](auto&... watchers) {
    return free_run(oscillator, start, options.half_cycle_limit, watchers...);
  };
  PhaseClock<double> clock;
  MarginKeeper<double> keeper;
  const FreeRun<double> run = options.times && options.margin ? run_with(clock, keeper)
                              : options.times                 ? run_with(clock)
                              : options.margin                ? run_with(keeper)
                                                              : run_with();
  Response response = metrics(run, oscillator.p);
  response.jump = largest_jump(oscillator, start, run);
  if (options.times && run.outcome != Outcome::never_stops) {
    response.stop_time = stop_time(clock, run, oscillator.p);
  }
  response.decision_margin = keeper.margin();
  return response;
}

double free_peak(const Oscillator& oscillator, const Start& start) {
  require_valid(oscillator, start);
  if (!oscillator.coulomb()) {
    if (const std::optional<DampedFree> motion =
            damped_free(oscillator, start, damped_cycle(oscillator.zeta))) {
      return first_peak(*motion);
    }
    return forced_response_of_valid(oscillator, start, NoExcitation(), {}, {}).peak_amplitude;
  }
  const HalfCycleMap<double> map(oscillator);
  const FirstLeg<double> leg = first_leg(map, start);
  double farthest = leg.farthest;
  if (leg.end == FirstLegEnd::arrival && map.without_friction()) {
    farthest = leg.radius;
  } else if (leg.end == FirstLegEnd::arrival) {
    if (const double energy = map.departure(leg.energy); energy > 0) {
      farthest = std::max(farthest, map.peak(energy, map.radius(energy)));
    }
  }
  return farthest / oscillator.p;
}

}  // namespace stillpoint
