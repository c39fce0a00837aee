// SPDX-License-Identifier: MIT
#include "sweep_run.hpp"

#include "entry_threads.hpp"
#include "progress.hpp"
#include "sweep_outcome.hpp"

#include <stillpoint/core/forced_batch.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>

#include <cassert>
#include <limits>

namespace stillpoint::cli {

namespace {

using Eigen::Index;
using enum Quantity;

/// What is found of every motion, and of a forced one beside.
constexpr std::initializer_list<Quantity> free_results{peak_amplitude, half_cycles, outcome,
                                                       stop_position, stop_time};
constexpr std::initializer_list<Quantity> forced_results{end_time, final_position, final_velocity,
                                                         sticks, stick_time};

constexpr double absent = std::numeric_limits<double>::quiet_NaN();
constexpr double never = std::numeric_limits<double>::infinity();

Oscillator oscillator(const SweepBlock& block, Index i) {
  return {.p = block[p][i], .f = block[f][i], .delta = block[delta][i]};
}

Start start(const SweepBlock& block, Index i) {
  return {.x0 = block[x0][i], .v0 = block[v0][i]};
}

void make_room(SweepBlock& block, std::initializer_list<Quantity> quantities) {
  for (const Quantity quantity : quantities) {
    block[quantity].resize(block.size);
  }
}

/// What stands for a time that is none.
double missing_time(Outcome outcome) {
  if (outcome == Outcome::never_stops) {
    return never;
  }
  return absent;
}

void set_response(SweepBlock& block, Index i, const Response& response) {
  block[peak_amplitude][i] = response.peak_amplitude;
  block[half_cycles][i] = response.half_cycles.value_or(never);
  block[outcome][i] = static_cast<double>(response.outcome);
  block[stop_position][i] = response.stop_position.value_or(absent);
  block[stop_time][i] = response.stop_time.value_or(missing_time(response.outcome));
}

void set_forced(SweepBlock& block, Index i, const ForcedResponse& response) {
  set_response(block, i, response);
  block[end_time][i] = response.end_time.value_or(missing_time(response.outcome));
  block[final_position][i] = response.final_position.value_or(absent);
  block[final_velocity][i] = response.final_velocity.value_or(absent);
  block[sticks][i] = response.sticks;
  block[stick_time][i] = response.stick_time;
}

/// More half-cycles than the task allows: that is all that is known of the motion.
void set_too_many(SweepBlock& block, Index i, std::initializer_list<Quantity> results) {
  for (const Quantity result : results) {
    block[result][i] = absent;
  }
  block[outcome][i] = static_cast<double>(too_many_half_cycles);
}

void make_room_for_response(SweepBlock& block) {
  make_room(block, free_results);
}

}  // namespace

void SweepRun::operator()(SweepBlock& block) {
  switch (task_.kind) {
    case SweepKind::free:
      return run_free(block);
    case SweepKind::forced:
      return run_forced(block);
    case SweepKind::design:
      return run_design(block);
  }
  assert(false && "a SweepKind outside its enumeration");
}

void SweepRun::run_free(SweepBlock& block) {
  if (!task_.from_zero) {
    return run_free_one_by_one(block);
  }
  const BatchOptions options{
      .times = task_.times,
      .half_cycle_limit = task_.half_cycle_limit.value_or(FreeOptions().half_cycle_limit),
      .threads = task_.threads};
  try {
    if (task_.one_v0_and_p) {
      free_batch(block[v0][0], block[p][0], block[f], block[delta], options, batch_);
    } else {
      free_batch(block[v0], block[p], block[f], block[delta], options, batch_);
    }
  } catch (const InputError&) {
    return run_free_one_by_one(block);  // which says what is wrong with the entry alone
  } catch (const TooManyHalfCycles&) {
    return run_free_one_by_one(block);
  }
  block[peak_amplitude].swap(batch_.peak_amplitude);
  block[half_cycles].swap(batch_.half_cycles);
  block[stop_position].swap(batch_.stop_position);
  block[stop_time].swap(batch_.stop_time);
  make_room(block, {outcome});
  for (Index i = 0; i < block.size; ++i) {
    block[outcome][i] = static_cast<double>(batch_.outcome[i]);
    if (batch_.outcome[i] == Outcome::never_stops) {
      block[stop_position][i] = absent;
    }
  }
}

void SweepRun::run_free_one_by_one(SweepBlock& block) const {
  make_room_for_response(block);
  const FreeOptions options{
      .times = task_.times,
      .margin = false,
      .half_cycle_limit = task_.half_cycle_limit.value_or(FreeOptions().half_cycle_limit)};
  for_each_entry(block.size, task_.threads, [&](Index i) {
    try {
      set_response(block, i, free_response(oscillator(block, i), start(block, i), options));
    } catch (const TooManyHalfCycles&) {
      set_too_many(block, i, free_results);
    }
  });
}

void SweepRun::run_forced(SweepBlock& block) const {
  make_room_for_response(block);
  make_room(block, forced_results);
  ForcedOptions options;
  options.t_end = task_.t_end;
  options.half_cycle_limit = task_.half_cycle_limit;
  options.go_on = [](double /*tau*/) { return !Progress::interrupted(); };
  if (task_.from_zero) {
    try {
      const auto responses = forced_batch(block[v0], block[p], block[f], block[delta],
                                          task_.excitation, {options, task_.threads});
      for (Index i = 0; i < block.size; ++i) {
        set_forced(block, i, responses[static_cast<std::size_t>(i)]);
      }
      return;
    } catch (const InputError&) {  // said below, of the entry alone
    } catch (const TooManyHalfCycles&) {
    }
  }
  for_each_entry(block.size, task_.threads, [&](Index i) {
    try {
      set_forced(block, i,
                 forced_response(oscillator(block, i), start(block, i), task_.excitation, options));
    } catch (const TooManyHalfCycles&) {
      set_too_many(block, i, free_results);
      set_too_many(block, i, forced_results);
    }
  });
}

void SweepRun::run_design(SweepBlock& block) const {
  make_room(block, {feasible, f, delta, tolerance, peak_amplitude, stop_time});
  const FreeOptions options{.times = task_.times, .margin = false};
  for_each_entry(block.size, task_.threads, [&](Index i) {
    const design::Problem problem{
        .v0 = block[v0][i], .p = block[p][i], .beta = block[beta][i], .criterion = task_.criterion};
    const auto found = design::search(problem, task_.limits, task_.search);
    block[feasible][i] = found ? 1 : 0;
    block[f][i] = found ? found->point.f : absent;
    block[delta][i] = found ? found->point.delta : absent;
    block[tolerance][i] = found ? found->point.tolerance : absent;
    block[peak_amplitude][i] = absent;
    block[stop_time][i] = absent;
    if (found) {
      const Response motion =
          free_response({.p = problem.p, .f = found->point.f, .delta = found->point.delta},
                        {.x0 = 0, .v0 = problem.v0}, options);
      block[peak_amplitude][i] = motion.peak_amplitude;
      block[stop_time][i] = motion.stop_time.value_or(absent);
    }
  });
}

}  // namespace stillpoint::cli
