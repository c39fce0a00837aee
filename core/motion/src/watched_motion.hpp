// SPDX-License-Identifier: MIT
#pragma once

// A forced motion watched event by event and piece by piece. It is compiled once, for any watcher:
// a virtual call costs little compared with a piece, while each copy of the kernel costs code.

#include "kernel/damped_curve.hpp"
#include "kernel/damped_piece.hpp"
#include "kernel/exact_sum.hpp"
#include "kernel/forced_state.hpp"
#include "kernel/harmonic_flow.hpp"
#include "kernel/linear_piece.hpp"

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/core/state.hpp>
#include <stillpoint/core/surface.hpp>

#include <variant>

namespace stillpoint {

/// The motion up to the next event, or the next edge of friction.
struct WatchedPiece {
  const ExactSum<double>& begin;  ///< p tau
  int direction;                  ///< that of y, v and the motion
  double length;                  ///< in p tau
  double load;                    ///< W / p where it begins
  std::variant<const HarmonicFlow<double>*, const LinearPiece<double>*, const DampedPiece<double>*,
               const DampedCurve<double>*>
      motion;
};

/// Units and symbols as in kernel/forced_run.hpp.
class MotionWatcher {
 public:
  static constexpr bool watches = true;

  MotionWatcher() = default;
  MotionWatcher(const MotionWatcher&) = delete;
  MotionWatcher& operator=(const MotionWatcher&) = delete;
  virtual ~MotionWatcher() = default;

  virtual void event(EventKind kind, const ExactSum<double>& now, double u, double v) = 0;
  virtual void follow(const WatchedPiece& /*piece*/) {}

  /// As the run reports it.
  template <class Piece>
  void piece(const ExactSum<double>& begin, int direction, const Piece& piece, double length,
             double load) {
    if constexpr (requires { piece.flow(); }) {
      follow({begin, direction, length, load, &piece.flow()});
    } else {
      follow({begin, direction, length, load, &piece});
    }
  }
};

/// The state at t_end or, without it, where forced_response goes on by the half-cycle map; or where
/// the motion ends before. The input must be valid.
ForcedState<double> watched_motion(const Oscillator& oscillator, const Surface& surface,
                                   const Start& start, const Excitation& excitation,
                                   const ForcedOptions& options, MotionWatcher& watcher);

}  // namespace stillpoint
