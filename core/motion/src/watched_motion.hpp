// SPDX-License-Identifier: MIT
#pragma once

// A forced motion watched event by event and piece by piece. It is compiled once, for any watcher:
// a virtual call costs little compared with a piece, while each copy of the kernel costs code.

#include "kernel/damped_harmonic_piece.hpp"
#include "kernel/damped_piece.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/forced_state.hpp"
#include "kernel/harmonic_piece.hpp"
#include "kernel/linear_piece.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

namespace stillpoint {

/// Units and symbols as in kernel/forced_run.hpp.
class MotionWatcher {
 public:
  static constexpr bool watches = true;

  MotionWatcher() = default;
  MotionWatcher(const MotionWatcher&) = delete;
  MotionWatcher& operator=(const MotionWatcher&) = delete;
  virtual ~MotionWatcher() = default;

  virtual void event(EventKind kind, const ExactSum<double>& now, double u, double v) = 0;
  /// The motion from `begin` to the next event.
  virtual void piece(const ExactSum<double>& begin, int direction,
                     const HarmonicPiece<double>& piece) = 0;
  virtual void piece(const ExactSum<double>& begin, int direction,
                     const LinearPiece<double>& piece) = 0;
  virtual void piece(const ExactSum<double>& begin, int direction,
                     const DampedPiece<double>& piece) = 0;
  virtual void piece(const ExactSum<double>& begin, int direction,
                     const DampedHarmonicPiece<double>& piece) = 0;
};

/// The state at tau = t_end, or where the motion ends before. The input must be valid.
ForcedState<double> watched_motion(const Oscillator& oscillator, const Surface& surface,
                                   const Start& start, const Excitation& excitation, double t_end,
                                   MotionWatcher& watcher, Patience patience);

}  // namespace stillpoint
