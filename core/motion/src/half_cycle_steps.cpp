// SPDX-License-Identifier: MIT
#include "kernel/half_cycle_steps.hpp"
#include "kernel/phase_clock.hpp"

#include <stillpoint/core/half_cycles.hpp>
#include <stillpoint/core/input_error.hpp>

#include <cmath>
#include <numbers>

namespace stillpoint {

namespace {

FirstLeg<double> validated_leg(const Oscillator& oscillator, const Start& start) {
  require_valid(oscillator, start);
  if (!oscillator.coulomb()) {
    throw InputError::missing(oscillator.zeta > 0 ? "damping" : "breakaway",
                              "half-cycles beyond the paper are those of a forced motion");
  }
  return first_leg(HalfCycleMap<double>(oscillator), start);
}

}  // namespace

HalfCycleSteps::HalfCycleSteps(const Oscillator& oscillator, const Start& start)
    : map_(oscillator),
      leg_(validated_leg(oscillator, start)),
      over_(leg_.end == FirstLegEnd::no_motion || leg_.end == FirstLegEnd::caught),
      side_(leg_.side),
      first_{leg_.energy, leg_.radius, leg_.farthest},
      crest_(first_) {}

double HalfCycleSteps::next_departure_speed() const {
  return std::sqrt(crest_.energy);
}

std::optional<HalfCycle> HalfCycleSteps::next() {
  if (over_) {
    return std::nullopt;
  }
  HalfCycle now;
  now.index = index_;
  now.side = side_;
  now.start_time = now.peak_time = time();
  now.departure_speed = index_ == 1 ? leg_.speed : next_departure_speed();
  if (index_ == 1 && leg_.end != FirstLegEnd::peak) {
    from_inward_start(now);
  } else {
    from_crest(now);
  }
  ++index_;
  return now;
}

void HalfCycleSteps::from_inward_start(HalfCycle& now) {
  now.peak = leg_.farthest / map_.p;
  small_ = first_leg_phase(map_, leg_);
  if (leg_.end == FirstLegEnd::rest) {
    end_in_dead_zone(now, leg_.rest);
    return;
  }
  end_at_zero(now, leg_.energy);
  passages_ = 0;
  first_ = crest_;
}

void HalfCycleSteps::from_crest(HalfCycle& now) {
  now.peak = crest_.peak / map_.p;
  small_ +=
      now.index == 1 ? first_leg_phase(map_, leg_) : PhaseClock<double>::up(map_, crest_.energy);
  now.peak_time = time();
  // With only phi the peak decides, because the closed form counts by it.
  const bool by_peak = map_.notch == 0;
  const bool returns = by_peak ? crest_.peak >= 2 * map_.phi : map_.returns(crest_.radius);
  if (returns) {
    const double arrival = map_.phi == 0 ? crest_.energy
                           : by_peak     ? crest_.peak * (crest_.peak - 2 * map_.phi)
                                         : map_.arrival(crest_.radius);
    half_turns_ += 1;
    small_ += PhaseClock<double>::down(map_, arrival) - std::numbers::pi;
    end_at_zero(now, arrival);
    return;
  }
  if (by_peak ? crest_.peak <= map_.phi : map_.rests_at_peak(crest_.radius)) {
    end_in_dead_zone(now, crest_.peak);
    return;
  }
  half_turns_ += 1;
  end_in_dead_zone(now, by_peak ? 2 * map_.phi - crest_.peak : map_.swing_back_rest(crest_.radius));
}

void HalfCycleSteps::end_in_dead_zone(HalfCycle& now, double rest) {
  now.end_time = time();
  now.end_position = now.side * (rest / map_.p);
  now.last = over_ = true;
}

void HalfCycleSteps::end_at_zero(HalfCycle& now, double arrival) {
  now.end_time = time();
  now.arrival_speed = std::sqrt(arrival);
  passages_ += 1;
  const double left = left_of(arrival);
  if (!(left > 0)) {
    now.impulse = now.arrival_speed;
    now.last = over_ = true;
    return;
  }
  now.impulse = map_.notch / (*now.arrival_speed + std::sqrt(left));
  crest_ = next_crest(left);
  side_ = -side_;
}

/// v^2 after the passage. With only the notch it is the first v^2 minus `passages_` notches,
/// rounded once: the sign is that of the exact remainder in ending.hpp. For an inward start the
/// first v^2 is that of the arrival, its only passage so far.
double HalfCycleSteps::left_of(double arrival) const {
  return map_.phi == 0 ? std::fma(-passages_, map_.notch, first_.energy) : map_.departure(arrival);
}

Crest<double> HalfCycleSteps::next_crest(double left) const {
  const bool first_passage_inwards = index_ == 1 && leg_.end == FirstLegEnd::arrival;
  if (map_.notch == 0 && !first_passage_inwards) {
    const double peak = std::fma(-passages_, 2 * map_.phi, first_.peak);
    return {left, peak + map_.phi, peak};
  }
  const double radius = map_.radius(left);
  return {left, radius, map_.peak(left, radius)};
}

double HalfCycleSteps::time() const {
  return (std::numbers::pi * half_turns_ + small_) / map_.p;
}

std::vector<HalfCycle> first_half_cycles(const Oscillator& oscillator, const Start& start,
                                         std::int64_t most) {
  HalfCycleSteps walk(oscillator, start);
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
