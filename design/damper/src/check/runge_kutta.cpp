// SPDX-License-Identifier: MIT

// The initial-value problems (9) of the paper, integrated step by step. In units of V0 and p:
// x'' = -s a - x with s = sgn x' on each monotone piece, a = f / (V0 p), notch = 2 Delta / V0^2.

#include "check/runge_kutta.hpp"

#include "check/monotone_piece.hpp"

#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

constexpr double first_kutta_step =
    1e-3;  // of 1 / p; the controller corrects a poor choice at once

}  // namespace

IntegratedMotion integrate_free_motion(const Oscillator& oscillator, double v0, double tolerance,
                                       double max_half_cycles) {
  require_valid(oscillator, {0, v0});
  require_within("v0", v0, smallest_speed, largest_speed);
  require_within("tolerance", tolerance, std::numeric_limits<double>::epsilon(), 1e-2);
  const double a = oscillator.f / oscillator.p / v0;
  const double notch = 2 * oscillator.delta / v0 / v0;
  if (a == 0 && notch == 0) {
    throw InputError("f, delta", "0", "some friction is needed for the motion to stop");
  }
  // From rest at a turn or with a speed at x = 0, to the next of them.
  const auto follow_next = [&](MonotonePiece& piece) {
    const auto motion = [&](const MotionState& now, MotionState& rate, double /*t*/) {
      rate = {now[1], -piece.direction * a - now[0]};
    };
    return follow(piece, motion, {tolerance, tolerance}, first_kutta_step, HUGE_VAL,
                  [](const MotionState&, double) {});
  };
  IntegratedMotion motion;
  motion.half_cycles = 0;
  double peak = 0;
  double acceleration = 0;
  MonotonePiece now{0, {0, 1}, 1};
  const auto stop = [&](double position) {
    motion.stopped = true;
    motion.stop_position = position * v0 / oscillator.p;
  };
  // Compared as in the region: if scaled by v0 first, an exact tie could round to the other side.
  if (2 * oscillator.delta > v0 * v0) {
    stop(0);
    return motion;
  }
  while (!motion.stopped && motion.half_cycles < max_half_cycles) {
    ++motion.half_cycles;
    follow_next(now);
    const double top = now.state[0];
    peak = std::max(peak, std::abs(top));
    acceleration = std::max(acceleration, std::abs(top) + a);
    if (std::abs(top) <= a) {
      stop(top);
      break;
    }
    now = {now.time, {top, 0}, std::copysign(1.0, -top)};
    if (follow_next(now) == PieceEnd::turn) {
      stop(now.state[0]);
      break;
    }
    const double speed = now.state[1];
    motion.arrival_speed = std::abs(speed) * v0;
    const double left = speed * speed - notch;
    if (left <= 0) {
      stop(0);
    } else {
      now.state = {0, std::copysign(std::sqrt(left), speed)};
    }
  }
  motion.peak_amplitude = peak * v0 / oscillator.p;
  motion.peak_acceleration = acceleration * v0 * oscillator.p;
  motion.stop_time = now.time / oscillator.p;
  return motion;
}

}  // namespace stillpoint::design
