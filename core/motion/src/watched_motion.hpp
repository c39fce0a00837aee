// SPDX-License-Identifier: MIT
#pragma once

// A forced motion, run once and watched event by event and piece by piece. It is compiled once, for
// any watcher: a virtual call costs little compared with a piece, while each copy of the kernel
// costs code.

#include "interface.hpp"
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

#include <functional>
#include <variant>
#include <vector>

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
class MotionWatcher : public Interface {
 public:
  virtual void event(EventKind kind, const ExactSum<double>& now, double u, double v) = 0;
  virtual void follow(const WatchedPiece& /*piece*/) {}
  /// It sees the motion up to this tau: known from the beginning, or where the load is over.
  virtual void set_horizon(double /*tau*/) {}
  /// Nothing more follows.
  virtual void end(const ForcedState<double>& state) = 0;
  /// Has seen all that it needs.
  [[nodiscard]] virtual bool full() const { return false; }
};

using MotionWatchers = std::vector<MotionWatcher*>;

/// What is wanted of a run. Without t_end it is one until the load is over; from there on it is
/// followed for each of what is wanted.
struct WatchedOptions : ForcedOptions {
  bool response{false};
  /// See the motion as far as the response needs it: without t_end to where forced_response goes on
  /// by the half-cycle map, or to its end.
  MotionWatchers to_end{};
  /// See it up to t_end or, without it, up to the horizon that each has for a response.
  MotionWatchers listing{};
  std::function<double(const MotionWatcher&, const ForcedResponse&)> horizon{};
};

/// If no response is wanted, only `cancelled` is set. Throws InputError as forced_response does.
ForcedResponse watched_motion(const Oscillator& oscillator, const Surface& surface,
                              const Start& start, const Excitation& excitation,
                              const WatchedOptions& options);

}  // namespace stillpoint
