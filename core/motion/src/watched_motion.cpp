// SPDX-License-Identifier: MIT
#include "watched_motion.hpp"

#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/on_surface.hpp"
#include "response_of_run.hpp"

namespace stillpoint {

ForcedState<double> watched_motion(const Oscillator& oscillator, const Surface& surface,
                                   const Start& start, const Excitation& excitation,
                                   const ForcedOptions& options, MotionWatcher& watcher) {
  const Patience patience(options.go_on, options.ask_every);
  return on_surface(oscillator, surface, start, watcher, patience, [&](auto& run) {
    limit(run, options);
    take_through(run, excitation, options);
    return run.state();
  });
}

}  // namespace stillpoint
