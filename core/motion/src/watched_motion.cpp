// SPDX-License-Identifier: MIT
#include "watched_motion.hpp"

#include "kernel/excitation_run.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/on_surface.hpp"

#include <utility>
#include <variant>

namespace stillpoint {

ForcedState<double> watched_motion(const Oscillator& oscillator, const Surface& surface,
                                   const Start& start, const Excitation& excitation, double t_end,
                                   MotionWatcher& watcher, Patience patience) {
  return on_surface(oscillator, surface, start, watcher, std::move(patience), [&](auto& run) {
    std::visit([&](const auto& kind) { run_until(run, kind, t_end); }, excitation);
    return run.state();
  });
}

}  // namespace stillpoint
