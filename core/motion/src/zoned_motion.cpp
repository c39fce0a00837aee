// SPDX-License-Identifier: MIT
#include "forced_response_of_valid.hpp"
#include "kernel/on_surface.hpp"
#include "lane_motion.hpp"
#include "record_motion.hpp"
#include "response_of_run.hpp"

namespace stillpoint {

ForcedResponse zoned_response_of_valid(const Oscillator& oscillator, const Start& start,
                                       const Excitation& excitation, const ForcedOptions& options,
                                       const Surface& surface) {
  NoWatcher nobody;
  return in_zones(oscillator, surface, start, nobody, Patience{options.go_on, options.ask_every},
                  [&](auto& run) { return response_of(run, oscillator, excitation, options); });
}

std::unique_ptr<RecordMotion> zoned_record_motion(const LaneTask& task, const Surface& surface) {
  return with_law(task.oscillator, surface, task.start,
                  [&]<class Law>(Law law) -> std::unique_ptr<RecordMotion> {
                    return std::make_unique<LaneMotion<Law>>(
                        task, without_zone(task.oscillator, surface), std::move(law));
                  });
}

}  // namespace stillpoint
