// SPDX-License-Identifier: MIT
#include "kernel/half_cycle_steps.hpp"

#include <stillpoint/core/half_cycle_walk.hpp>

namespace stillpoint {

HalfCycleWalk::HalfCycleWalk(const Oscillator& oscillator, const Start& start)
    : steps_(std::make_unique<HalfCycleSteps>(oscillator, start)) {}

HalfCycleWalk::HalfCycleWalk(const HalfCycleWalk& other)
    : steps_(std::make_unique<HalfCycleSteps>(*other.steps_)) {}

HalfCycleWalk::HalfCycleWalk(HalfCycleWalk&& other) noexcept = default;

HalfCycleWalk& HalfCycleWalk::operator=(const HalfCycleWalk& other) {
  return *this = HalfCycleWalk(other);
}

HalfCycleWalk& HalfCycleWalk::operator=(HalfCycleWalk&& other) noexcept = default;

HalfCycleWalk::~HalfCycleWalk() = default;

std::optional<HalfCycle> HalfCycleWalk::next() {
  return steps_->next();
}

double HalfCycleWalk::next_departure_speed() const {
  return steps_->next_departure_speed();
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
