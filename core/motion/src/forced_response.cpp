// SPDX-License-Identifier: MIT
#include "forced_response_of_valid.hpp"
#include "response_of_run.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/input_error.hpp>

namespace stillpoint {

void require_valid(const ForcedOptions& options) {
  if (options.half_cycle_limit) {
    require_within("half_cycle_limit", *options.half_cycle_limit, 1, 1e15);
  }
}

ForcedResponse forced_response(const Oscillator& oscillator, const Start& start,
                               const Excitation& excitation, const ForcedOptions& options,
                               const Surface& surface) {
  require_valid(oscillator, start, excitation, options.t_end);
  require_valid(oscillator, surface);
  require_valid(options);
  return forced_response_of_valid(oscillator, start, excitation, options, surface);
}

ForcedResponse forced_response_of_valid(const Oscillator& oscillator, const Start& start,
                                        const Excitation& excitation, const ForcedOptions& options,
                                        const Surface& surface) {
  if (!paper_motion(oscillator, surface)) {
    return zoned_response_of_valid(oscillator, start, excitation, options, surface);
  }
  NoWatcher nobody;
  ForcedRun<double, NoWatcher> run(oscillator, start, nobody,
                                   Patience{options.go_on, options.ask_every});
  return response_of(run, oscillator, excitation, options);
}

}  // namespace stillpoint
