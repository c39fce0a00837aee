// SPDX-License-Identifier: MIT
#pragma once

// The response of a forced run, whatever its law of friction. The paper's law and zones are
// compiled apart (forced_response.cpp, zoned_motion.cpp): together the compiler inlines less of
// either.

#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/free_run.hpp"
#include "kernel/margin_keeper.hpp"
#include "kernel/phase_clock.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

namespace stillpoint {

/// Everything that does not depend on how the run ended.
template <class Run>
ForcedResponse so_far(const Run& run) {
  const ForcedState<double>& state = run.state();
  const double p = run.map().p;
  ForcedResponse response;
  response.peak_amplitude = std::max(state.farthest, std::abs(state.u)) / p;
  response.peak_acceleration = state.acceleration * p;
  response.peak_absolute_acceleration =
      std::max(state.transmitted.slid * p, state.transmitted.held);
  if (state.transmitted.locked > 0) {
    response.locked_from = state.rest_begin.value() / p;
    response.largest_load_while_locked = state.transmitted.locked;
  }
  response.half_cycles = state.moved ? static_cast<double>(state.passages) + 1 : 0;
  response.turning_points = static_cast<double>(state.turning_points);
  response.zero_passages = static_cast<double>(state.passages);
  response.arrival_speed = state.arrival_speed;
  response.jump = state.jump;
  if (state.margin.any()) {
    response.decision_margin = state.margin.value();
  }
  response.sticks = static_cast<double>(state.sticks);
  response.stick_time = state.stuck.value() / p;
  response.left_notch_from_rest = state.left_notch_from_rest;
  response.cancelled = run.cancelled();
  return response;
}

inline void end_at_rest(ForcedResponse& response, Outcome outcome, double stop_time,
                        double position) {
  response.outcome = outcome;
  response.stops_at_zero = outcome == Outcome::stopped_at_zero;
  response.stop_time = response.end_time = stop_time;
  response.stop_position = response.final_position = position;
  response.final_velocity = 0;
}

/// No friction slows the motion any more: a count of what came before would mean nothing.
inline void end_nowhere(ForcedResponse& response) {
  response.outcome = Outcome::never_stops;
  response.half_cycles = response.turning_points = response.zero_passages = std::nullopt;
  response.arrival_speed = std::nullopt;
}

/// The run ended while the mass moved, or while friction held it for an unknown time.
template <class Run>
void end_running(ForcedResponse& response, const Run& run) {
  const ForcedState<double>& state = run.state();
  const double p = run.map().p;
  response.outcome = Outcome::running;
  response.end_time = state.now.value() / p;
  response.final_position = state.u / p;
  response.final_velocity = state.v;
  const double waited = state.now.minus(state.rest_begin);
  if (state.v == 0 && !state.fresh && waited > 0) {
    response.sticks += 1;
    response.stick_time += waited / p;
  }
}

/// The free motion from the turn that the run has reached, to its end by the half-cycle map.
template <class Run>
void end_free(ForcedResponse& response, const Run& run, const Oscillator& oscillator,
              double half_cycle_limit) {
  const double p = oscillator.p;
  const double begin = run.state().now.value();
  if (const double waited = run.state().now.minus(run.state().rest_begin); waited > 0) {
    response.sticks += 1;  // held until the excitation ended
    response.stick_time += waited / p;
  }
  PhaseClock<double> clock;
  MarginKeeper<double> keeper;
  const Start turn{run.state().u / p, 0};
  const FreeRun<double> free = free_run(oscillator, turn, half_cycle_limit, clock, keeper);
  response.peak_amplitude = std::max(response.peak_amplitude, free.farthest / p);
  response.peak_acceleration = std::max(response.peak_acceleration, free.acceleration * p);
  response.peak_absolute_acceleration =
      std::max(response.peak_absolute_acceleration, free.acceleration * p);
  response.jump = std::max(response.jump, largest_jump(oscillator, turn, free));
  if (keeper.margin()) {
    response.decision_margin =
        std::min(*keeper.margin(), response.decision_margin.value_or(*keeper.margin()));
  }
  if (free.outcome == Outcome::never_stops) {
    end_nowhere(response);
    return;
  }
  *response.half_cycles += free.passages;
  if (free.moves && !run.state().moved) {
    *response.half_cycles += 1;
  }
  *response.zero_passages += free.passages;
  *response.turning_points += free.turning_points;
  if (free.arrival) {
    response.arrival_speed = std::sqrt(*free.arrival);
  }
  const double stop_time = (begin + clock.phase()) / p;
  if (!std::isfinite(stop_time)) {
    throw TooManyHalfCycles(*response.half_cycles, largest_square * p);
  }
  end_at_rest(response, free.outcome, stop_time, free.rest / p);
}

/// Before the run begins.
template <class Run>
void limit(Run& run, const ForcedOptions& options) {
  constexpr bool in_zones = std::decay_t<decltype(run.law())>::in_zones;
  if (options.half_cycle_limit || (in_zones && !options.t_end)) {
    run.allow_half_cycles(options.half_cycle_limit.value_or(FreeOptions().half_cycle_limit));
  }
}

/// The same, and what is requested.
template <class Run>
[[gnu::noinline]] void prepare(Run& run, const Oscillator& oscillator, const Excitation& excitation,
                               const ForcedOptions& options) {
  limit(run, options);
  run.state().transmitted.largest_load = load_while_held(excitation, oscillator.p);
}

/// After the run, which ended at tau = `end` or went on free from there.
template <class Run>
[[gnu::noinline]] ForcedResponse response_to(Run& run, double end, const Oscillator& oscillator,
                                             const ForcedOptions& options) {
  feel_the_end(run.state(), run.law(), ExactSum<double>::product(oscillator.p, end));
  ForcedResponse response = so_far(run);
  const ForcedState<double>& state = run.state();
  if (state.outcome == Outcome::never_stops) {
    end_nowhere(response);
  } else if (state.outcome) {
    end_at_rest(response, *state.outcome, state.rest_begin.value() / oscillator.p,
                state.u / oscillator.p);
  } else if (options.t_end || run.cancelled()) {
    end_running(response, run);
  } else {
    end_free(response, run, oscillator,
             options.half_cycle_limit.value_or(FreeOptions().half_cycle_limit));
  }
  return response;
}

/// To t_end or, without it, as far as a run goes.
template <class Run>
void take_through(Run& run, const Excitation& excitation, const ForcedOptions& options) {
  std::visit(
      [&](const auto& kind) {
        if (options.t_end) {
          run_until(run, kind, *options.t_end);
        } else {
          run_to_free_turn(run, kind);
        }
      },
      excitation);
}

template <class Run>
ForcedResponse response_of(Run& run, const Oscillator& oscillator, const Excitation& excitation,
                           const ForcedOptions& options) {
  prepare(run, oscillator, excitation, options);
  take_through(run, excitation, options);
  const double end = options.t_end ? *options.t_end : duration(excitation).value();
  return response_to(run, end, oscillator, options);
}

}  // namespace stillpoint
