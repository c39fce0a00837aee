// SPDX-License-Identifier: MIT
#pragma once

// A separate kind of run for a surface that is not the paper's and for damping, so that other
// motions do not pay for them.

#include "kernel/damped.hpp"
#include "kernel/forced_run.hpp"
#include "kernel/zoned_friction.hpp"

#include <stillpoint/core/surface.hpp>

#include <utility>

namespace stillpoint {

/// Without the notch that is a zone of the surface.
template <class Real>
BasicOscillator<Real> without_zone(BasicOscillator<Real> oscillator,
                                   const BasicSurface<Real>& surface) {
  if (surface.notch_width) {
    oscillator.delta = Real(0);
  }
  return oscillator;
}

/// What `use` returns for the law of a motion that is not the paper's.
template <class Real, class Use>
auto with_law(const BasicOscillator<Real>& oscillator, const BasicSurface<Real>& surface,
              const BasicStart<Real>& start, const Use& use) {
  ZonedFriction<Real> zones(oscillator, surface, start);
  return oscillator.zeta > 0 ? use(Damped(std::move(zones), oscillator.zeta))
                             : use(std::move(zones));
}

/// What `follow` returns for the run in zones, which is at its start.
template <class Real, class Watcher, class Follow>
auto in_zones(const BasicOscillator<Real>& oscillator, const BasicSurface<Real>& surface,
              const BasicStart<Real>& start, Watcher& watcher, Patience patience,
              const Follow& follow) {
  return with_law(oscillator, surface, start, [&]<class Law>(Law law) {
    ForcedRun<Real, Watcher, Law> run(without_zone(oscillator, surface), std::move(law), start,
                                      watcher, std::move(patience));
    return follow(run);
  });
}

/// The same for any surface.
template <class Real, class Watcher, class Follow>
auto on_surface(const BasicOscillator<Real>& oscillator, const BasicSurface<Real>& surface,
                const BasicStart<Real>& start, Watcher& watcher, Patience patience,
                const Follow& follow) {
  if (!paper_motion(oscillator, surface)) {
    return in_zones(oscillator, surface, start, watcher, std::move(patience), follow);
  }
  ForcedRun<Real, Watcher> run(oscillator, start, watcher, std::move(patience));
  return follow(run);
}

}  // namespace stillpoint
