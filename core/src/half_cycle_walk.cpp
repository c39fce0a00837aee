// SPDX-License-Identifier: MIT
#include <stillpoint/core/half_cycle_walk.hpp>
#include <stillpoint/core/phase_clock.hpp>

#include <cmath>
#include <numbers>

namespace stillpoint {

namespace {

FirstLeg<double> validated_leg(const Oscillator<double>& oscillator, const Start<double>& start) {
  require_valid(oscillator, start);
  return first_leg(HalfCycleMap<double>(oscillator), start);
}

}  // namespace

HalfCycleWalk::HalfCycleWalk(const Oscillator<double>& oscillator, const Start<double>& start)
    : map_(oscillator),
      leg_(validated_leg(oscillator, start)),
      over_(leg_.end == FirstLegEnd::no_motion || leg_.end == FirstLegEnd::caught),
      side_(leg_.side),
      radius_(leg_.radius) {}

double HalfCycleWalk::first_virtual_phase() const {
  return -std::atan2(leg_.speed, leg_.distance - map_.phi);
}

double HalfCycleWalk::next_departure_speed() const {
  return std::sqrt(energy_);
}

std::optional<HalfCycle> HalfCycleWalk::next() {
  if (over_) {
    return std::nullopt;
  }
  const bool first = index_ == 1;
  const double start_phase = std::numbers::pi * half_turns_ + small_;
  HalfCycle now;
  now.index = index_++;
  now.side = side_;
  now.start_time = time(start_phase);
  const double leg_phase = first ? first_leg_phase(map_, leg_) : 0;
  if (first && leg_.end != FirstLegEnd::peak) {
    now.departure_speed = leg_.speed;
    now.peak = leg_.farthest / map_.p;
    small_ += leg_phase;
    if (leg_.end == FirstLegEnd::rest) {
      end_in_dead_zone(now, leg_.rest);
    } else {
      pass_or_stop(now, leg_.arrival);
    }
    return now;
  }
  now.departure_speed = first ? leg_.speed : std::sqrt(energy_);
  const double peak = first ? leg_.farthest : map_.peak(energy_, radius_);
  now.peak = peak / map_.p;
  small_ += first ? leg_phase : PhaseClock<double>::up(map_, energy_);
  now.peak_time = time(std::numbers::pi * half_turns_ + small_);
  if (map_.returns(radius_)) {
    const double arrival = map_.arrival(radius_);
    half_turns_ += 1;
    small_ += PhaseClock<double>::down(map_, arrival) - std::numbers::pi;
    pass_or_stop(now, arrival);
  } else if (map_.rests_at_peak(radius_)) {
    end_in_dead_zone(now, peak);
  } else {
    half_turns_ += 1;
    end_in_dead_zone(now, map_.swing_back_rest(radius_));
  }
  return now;
}

void HalfCycleWalk::end_in_dead_zone(HalfCycle& now, double rest) {
  now.end_time = time(std::numbers::pi * half_turns_ + small_);
  now.end_position = now.side * (rest / map_.p);
  now.last = over_ = true;
}

void HalfCycleWalk::pass_or_stop(HalfCycle& now, double arrival) {
  now.end_time = time(std::numbers::pi * half_turns_ + small_);
  now.arrival_speed = std::sqrt(arrival);
  energy_ = map_.departure(arrival);
  if (!(energy_ > 0)) {
    now.last = over_ = true;
    return;
  }
  radius_ = map_.radius(energy_);
  side_ = -side_;
}

std::vector<HalfCycle> first_half_cycles(const Oscillator<double>& oscillator,
                                         const Start<double>& start, std::int64_t most) {
  HalfCycleWalk walk(oscillator, start);
  std::vector<HalfCycle> list;
  while (static_cast<std::int64_t>(list.size()) < most) {
    const std::optional<HalfCycle> next = walk.next();
    if (!next) {
      break;
    }
    list.push_back(*next);
  }
  return list;
}

}  // namespace stillpoint
