// SPDX-License-Identifier: MIT
#pragma once

// Walks through a free motion half-cycle by half-cycle, times included, with the state that
// Trajectory needs.

#include "kernel/ending.hpp"
#include "kernel/first_leg.hpp"
#include "kernel/half_cycle_map.hpp"

#include <stillpoint/core/half_cycles.hpp>

#include <cstdint>
#include <optional>

namespace stillpoint {

class HalfCycleSteps {
 public:
  HalfCycleSteps(const Oscillator& oscillator, const Start& start);

  /// The next half-cycle; empty after the last one. A motion without friction goes on for ever.
  [[nodiscard]] std::optional<HalfCycle> next();

  /// |x'| with which the next half-cycle leaves x = 0.
  [[nodiscard]] double next_departure_speed() const;

  [[nodiscard]] const FirstLeg<double>& leg() const { return leg_; }
  [[nodiscard]] const HalfCycleMap<double>& map() const { return map_; }

 private:
  void from_inward_start(HalfCycle& now);
  void from_crest(HalfCycle& now);
  void end_in_dead_zone(HalfCycle& now, double rest);
  void end_at_zero(HalfCycle& now, double arrival);
  [[nodiscard]] Crest<double> next_crest(double left) const;
  [[nodiscard]] double left_of(double arrival) const;
  [[nodiscard]] double time() const;

  HalfCycleMap<double> map_;
  FirstLeg<double> leg_;
  bool over_;
  std::int64_t index_{1};
  int side_;
  Crest<double> first_;   ///< the closed forms count from here
  Crest<double> crest_;   ///< of the half-cycle to come
  double passages_{0};    ///< since first_
  double half_turns_{0};  ///< phases are pi half_turns_ + small_: no digit of pi k is lost
  double small_{0};
};

}  // namespace stillpoint
