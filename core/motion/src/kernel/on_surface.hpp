// SPDX-License-Identifier: MIT
#pragma once

// A separate kind of run for a surface that is not the paper's, so that other motions do not pay
// for it.

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

/// What `follow` returns for the run in zones, which is at its start.
template <class Real, class Watcher, class Follow>
auto in_zones(const BasicOscillator<Real>& oscillator, const BasicSurface<Real>& surface,
              const BasicStart<Real>& start, Watcher& watcher, Patience patience,
              const Follow& follow) {
  ForcedRun<Real, Watcher, ZonedFriction<Real>> run(without_zone(oscillator, surface),
                                                    ZonedFriction<Real>(oscillator, surface, start),
                                                    start, watcher, std::move(patience));
  return follow(run);
}

/// The same for any surface.
template <class Real, class Watcher, class Follow>
auto on_surface(const BasicOscillator<Real>& oscillator, const BasicSurface<Real>& surface,
                const BasicStart<Real>& start, Watcher& watcher, Patience patience,
                const Follow& follow) {
  if (!surface.plain()) {
    return in_zones(oscillator, surface, start, watcher, std::move(patience), follow);
  }
  ForcedRun<Real, Watcher> run(oscillator, start, watcher, std::move(patience));
  return follow(run);
}

}  // namespace stillpoint
