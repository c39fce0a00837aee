// SPDX-License-Identifier: MIT

// In units of k and p: x'' = -W - s f - x, s = sgn x' on each slide, W the load of a pulse with
// k = p = 1. A slide is also cut where the pulse ends.

#include "check/monotone_piece.hpp"
#include "check/runge_kutta.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design {

namespace {

struct Load {
  double lambda;
  double ends;
  bool flat;

  /// While the pulse lasts; smooth beyond its end, because a step may reach there.
  [[nodiscard]] double during(double t) const {
    return flat ? 1 : elementary::sin_cos(lambda * t).sine;
  }
};

Load load_of(const Pulse& pulse, double p) {
  const double lambda = angular_frequency(pulse) / p;
  const double angle = std::holds_alternative<FullSine>(pulse) ? 2 : 1;
  return {lambda, angle * std::numbers::pi / lambda, std::holds_alternative<Rectangle>(pulse)};
}

class Run {
 public:
  Run(const Load& load, double f, double size, double tolerance)
      : load_(load), f_(f), tolerance_{tolerance * size, tolerance} {}

  double time{0};
  MotionState state{0, 0};
  double peak{0};
  double acceleration{0};

  /// At rest until the load exceeds friction; false if it never does.
  bool released() {
    const auto excess = [this](double t) { return std::abs(load_.during(t) + state[0]) - f_; };
    constexpr int looks = 4000;  // over the whole pulse; a crest between two of them is missed
    while (time < load_.ends) {
      if (excess(time) > 0) {
        return true;
      }
      const double next = std::min(load_.ends, time + load_.ends / looks);
      time = excess(next) > 0 && next < load_.ends ? bracketed_root(excess, time, next) : next;
      if (next < load_.ends && excess(next) > 0) {
        return true;
      }
    }
    return std::abs(state[0]) > f_;
  }

  /// From rest against the load, or on with the sign of v.
  PieceEnd slide() {
    const bool loaded = time < load_.ends;
    const double force = (loaded ? load_.during(time) : 0) + state[0];
    const double ahead = (loaded && state[1] == 0 && std::abs(force) <= f_)
                             ? (load_.during(time + load_.ends * 1e-9) + state[0])
                             : force;
    const double direction = std::copysign(1.0, state[1] != 0 ? state[1] : -ahead);
    const auto motion = [&](const MotionState& now, MotionState& rate, double t) {
      rate = {now[1], -(loaded ? load_.during(t) : 0) - direction * f_ - now[0]};
    };
    const auto look = [&](const MotionState& now, double t) {
      MotionState rate;
      motion(now, rate, t);
      acceleration = std::max(acceleration, std::abs(rate[1]));
    };
    constexpr double part = 1e-4;  // of the pulse, or of 1 / p; the controller corrects it at once
    MonotonePiece piece{time, state, direction};
    const PieceEnd end = follow(piece, motion, tolerance_, part * std::min(1.0, load_.ends),
                                loaded ? load_.ends : HUGE_VAL, look);
    time = piece.time;
    state = piece.state;
    if (end != PieceEnd::arrival) {
      peak = std::max(peak, std::abs(state[0]));
    }
    if (end == PieceEnd::turn) {
      state[1] = 0;
    }
    return end;
  }

 private:
  Load load_;
  double f_;
  IntegratorTolerance tolerance_;
};

}  // namespace

IntegratedMotion integrate_under_pulse(const Oscillator& oscillator, const Pulse& pulse,
                                       double size, double tolerance) {
  const double p = oscillator.p;
  const double k = peak_load(pulse);
  const double length = k / p / p;
  Run run(load_of(pulse, p), oscillator.f / k, size / length, tolerance);
  IntegratedMotion motion;
  motion.half_cycles = 1;
  bool moving = false;
  constexpr int most_slides = 10'000;
  for (int i = 0; i < most_slides; ++i) {
    if (!moving && !run.released()) {
      motion.stopped = true;
      break;
    }
    const PieceEnd end = run.slide();
    moving = end == PieceEnd::time && run.state[1] != 0;
    if (end == PieceEnd::arrival) {
      const double speed = std::abs(run.state[1]);
      motion.arrival_speed = speed * k / p;
      motion.stopped = speed * speed <= 2 * oscillator.delta / length / k;
      motion.half_cycles = motion.stopped ? 1 : 2;
      run.state[0] = 0;
      break;
    }
  }
  motion.peak_amplitude = run.peak * length;
  motion.peak_acceleration = run.acceleration * k;
  motion.stop_time = run.time / p;
  motion.stop_position = run.state[0] * length;
  return motion;
}

}  // namespace stillpoint::design
