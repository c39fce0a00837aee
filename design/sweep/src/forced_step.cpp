// SPDX-License-Identifier: MIT
#include "step.hpp"
#include "step_results.hpp"

#include <stillpoint/core/forced_batch.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;
using enum Quantity;

/// What is found of a forced motion besides.
constexpr std::initializer_list<Quantity> forced_results{end_time, final_position, final_velocity,
                                                         sticks, stick_time};

void set_forced(SweepBlock& block, Index i, const ForcedResponse& response) {
  set_response(block, i, response);
  block[end_time][i] = response.end_time.value_or(missing_time(response.outcome));
  block[final_position][i] = response.final_position.value_or(absent);
  block[final_velocity][i] = response.final_velocity.value_or(absent);
  block[sticks][i] = response.sticks;
  block[stick_time][i] = response.stick_time;
}

}  // namespace

void SweepStep::run_forced(SweepBlock& block) const {
  make_room(block, motion_results);
  make_room(block, forced_results);
  ForcedOptions options;
  options.t_end = spec_.t_end;
  options.half_cycle_limit = spec_.half_cycle_limit;
  options.go_on = [this](double /*tau*/) { return !stop_.stop_requested(); };
  if (from_zero_) {
    try {
      const auto responses = forced_batch(block[v0], block[p], block[f], block[delta],
                                          spec_.excitation, {options, spec_.threads});
      for (Index i = 0; i < block.size; ++i) {
        set_forced(block, i, responses[static_cast<std::size_t>(i)]);
      }
      return;
    } catch (const InputError&) {  // repeated below for the entry alone
    } catch (const TooManyHalfCycles&) {
    }
  }
  for_each(block, [&](Index i) {
    try {
      set_forced(block, i,
                 forced_response(oscillator(block, i), start(block, i), spec_.excitation, options));
    } catch (const TooManyHalfCycles&) {
      set_too_many(block, i, motion_results);
      set_too_many(block, i, forced_results);
    }
  });
}

}  // namespace stillpoint::sweep
