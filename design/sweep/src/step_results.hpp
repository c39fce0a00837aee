// SPDX-License-Identifier: MIT
#pragma once

// How a step writes what it found into the columns of a block.

#include "block.hpp"

#include <stillpoint/sweep/outcome.hpp>

#include <stillpoint/core/free_motion.hpp>

#include <initializer_list>
#include <limits>

namespace stillpoint::sweep {

/// What is found of every motion.
inline constexpr std::initializer_list<Quantity> motion_results{
    Quantity::peak_amplitude, Quantity::half_cycles, Quantity::outcome, Quantity::stop_position,
    Quantity::stop_time};

/// A value that does not exist, and a time that never comes.
inline constexpr double absent = std::numeric_limits<double>::quiet_NaN();
inline constexpr double never = std::numeric_limits<double>::infinity();

inline Oscillator oscillator(const SweepBlock& block, Eigen::Index i) {
  return {
      .p = block[Quantity::p][i], .f = block[Quantity::f][i], .delta = block[Quantity::delta][i]};
}

inline Start start(const SweepBlock& block, Eigen::Index i) {
  return {.x0 = block[Quantity::x0][i], .v0 = block[Quantity::v0][i]};
}

inline void make_room(SweepBlock& block, std::initializer_list<Quantity> quantities) {
  for (const Quantity quantity : quantities) {
    block[quantity].resize(block.size);
  }
}

/// What stands for a time that a motion does not have.
inline double missing_time(Outcome outcome) {
  if (outcome == Outcome::never_stops) {
    return never;
  }
  return absent;
}

inline void set_response(SweepBlock& block, Eigen::Index i, const Response& response) {
  using enum Quantity;
  block[peak_amplitude][i] = response.peak_amplitude;
  block[half_cycles][i] = response.half_cycles.value_or(never);
  block[outcome][i] = static_cast<double>(response.outcome);
  block[stop_position][i] = response.stop_position.value_or(absent);
  block[stop_time][i] = response.stop_time.value_or(missing_time(response.outcome));
}

/// The motion has more half-cycles than the sweep allows; nothing else is known of it.
inline void set_too_many(SweepBlock& block, Eigen::Index i,
                         std::initializer_list<Quantity> results) {
  for (const Quantity result : results) {
    block[result][i] = absent;
  }
  block[Quantity::outcome][i] = static_cast<double>(too_many_half_cycles);
}

}  // namespace stillpoint::sweep
