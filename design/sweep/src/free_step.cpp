// SPDX-License-Identifier: MIT
#include "step.hpp"
#include "step_results.hpp"

#include <stillpoint/core/input_error.hpp>

namespace stillpoint::sweep {

namespace {
using Eigen::Index;
using enum Quantity;
}  // namespace

void SweepStep::run_free(SweepBlock& block) {
  if (!from_zero_) {
    return run_free_one_by_one(block);
  }
  const BatchOptions options{
      .times = times_,
      .half_cycle_limit = spec_.half_cycle_limit.value_or(FreeOptions().half_cycle_limit),
      .threads = spec_.threads};
  try {
    if (one_v0_and_p_) {
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

void SweepStep::run_free_one_by_one(SweepBlock& block) const {
  make_room(block, motion_results);
  const FreeOptions options{
      .times = times_,
      .margin = false,
      .half_cycle_limit = spec_.half_cycle_limit.value_or(FreeOptions().half_cycle_limit)};
  for_each(block, [&](Index i) {
    try {
      set_response(block, i, free_response(oscillator(block, i), start(block, i), options));
    } catch (const TooManyHalfCycles&) {
      set_too_many(block, i, motion_results);
    }
  });
}

}  // namespace stillpoint::sweep
