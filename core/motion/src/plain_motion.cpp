// SPDX-License-Identifier: MIT
#include "lane_motion.hpp"
#include "record_motion.hpp"

namespace stillpoint {

std::unique_ptr<RecordMotion> record_motion(const LaneTask& task) {
  using Law = ConstantFriction<double>;
  return std::make_unique<LaneMotion<Law>>(task, task.oscillator, Law(task.oscillator));
}

}  // namespace stillpoint
