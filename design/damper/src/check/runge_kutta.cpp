// SPDX-License-Identifier: MIT

// The initial-value problems (9) of the paper, integrated step by step. In units of V0 and p:
// x'' = -s a - x with s = sgn x' on each monotone piece, a = f / (V0 p), notch = 2 Delta / V0^2.

#include "check/runge_kutta.hpp"

#include "check/bracketed_root.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/input_error.hpp>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace stillpoint::design {

namespace {

using State = std::array<double, 2>;  // x, v

namespace odeint = boost::numeric::odeint;

/// odeint's rule for the next step, with a power that is the same on every machine.
class StepAdjuster : public odeint::default_step_adjuster<double, double> {
 public:
  [[nodiscard]] static double decrease_step(double step, double error, int order) {
    return step * std::max(0.9 * elementary::pow(error, -1.0 / (order - 1)), 0.2);
  }
  [[nodiscard]] static double increase_step(double step, double error, int order) {
    constexpr double most = 5;
    return error < 0.5
               ? step * (0.9 * elementary::pow(std::max(elementary::pow(most, -order), error),
                                               -1.0 / order))
               : step;
  }
};

using Kutta = odeint::runge_kutta_dopri5<State>;
using ErrorChecker =
    odeint::default_error_checker<double, Kutta::algebra_type, Kutta::operations_type>;
using Stepper = odeint::dense_output_runge_kutta<
    odeint::controlled_runge_kutta<Kutta, ErrorChecker, StepAdjuster>>;

constexpr double first_kutta_step = 1e-3;  // of 1 / p; the controller mends a poor choice at once

struct PieceEnd {
  double time;
  State state;
  bool turned;  // v = 0; otherwise x = 0
};

class Integrator {
 public:
  Integrator(double a, double tolerance) : a_(a), tolerance_(tolerance) {}

  /// From `state` at `time`, moving with the sign of v (or `direction` at v = 0), to the first turn
  /// or the first arrival at x = 0, whichever comes first.
  [[nodiscard]] PieceEnd piece(double time, const State& state, double direction) const {
    const auto motion = [this, direction](const State& now, State& rate, double /*t*/) {
      rate = {now[1], -direction * a_ - now[0]};
    };
    Stepper stepper({ErrorChecker(tolerance_, tolerance_), StepAdjuster()});
    stepper.initialize(state, time, first_kutta_step);
    const bool inward = state[0] * direction < 0;
    for (;;) {
      const auto [from, to] = stepper.do_step(motion);
      const auto at = [&stepper](double t) {
        State now;
        stepper.calc_state(t, now);
        return now;
      };
      const auto position = [&](double t) { return at(t)[0]; };
      const auto velocity = [&](double t) { return at(t)[1]; };
      // A graze dips below x = 0 and is back before the step ends, so where the motion turns, the
      // position at the turn decides, not the one at the end of the step.
      const bool turned = at(to)[1] * direction <= 0;
      const double last = turned ? bracketed_root(velocity, from, to) : to;
      if (inward && at(last)[0] * direction >= 0) {
        const double passage = bracketed_root(position, from, last);
        return {passage, at(passage), false};
      }
      if (turned) {
        return {last, at(last), true};
      }
    }
  }

 private:
  double a_;
  double tolerance_;
};

}  // namespace

IntegratedMotion integrate_free_motion(const Oscillator& oscillator, double v0, double tolerance,
                                       std::int64_t max_half_cycles) {
  require_valid(oscillator, {0, v0});
  require_within("v0", v0, smallest_speed, largest_speed);
  require_within("tolerance", tolerance, std::numeric_limits<double>::epsilon(), 1e-2);
  const double a = oscillator.f / oscillator.p / v0;
  const double notch = 2 * oscillator.delta / v0 / v0;
  if (a == 0 && notch == 0) {
    throw InputError("f, delta", "0", "some friction is needed for the motion to stop");
  }
  const Integrator integrator(a, tolerance);
  IntegratedMotion motion;
  double peak = 0;
  double acceleration = 0;
  double time = 0;
  State state{0, 1};
  const auto stop = [&](double position) {
    motion.stopped = true;
    motion.stop_position = position * v0 / oscillator.p;
  };
  // As the region compares it: scaled by v0 first, an exact tie could round to the other side.
  if (2 * oscillator.delta > v0 * v0) {
    stop(0);
    return motion;
  }
  while (!motion.stopped && motion.half_cycles < max_half_cycles) {
    ++motion.half_cycles;
    const PieceEnd top = integrator.piece(time, state, std::copysign(1.0, state[1]));
    time = top.time;
    peak = std::max(peak, std::abs(top.state[0]));
    acceleration = std::max(acceleration, std::abs(top.state[0]) + a);
    if (std::abs(top.state[0]) <= a) {
      stop(top.state[0]);
      break;
    }
    const PieceEnd down =
        integrator.piece(time, {top.state[0], 0}, std::copysign(1.0, -top.state[0]));
    time = down.time;
    const double left = down.state[1] * down.state[1] - notch;
    if (!down.turned) {
      motion.arrival_speed = std::abs(down.state[1]) * v0;
    }
    if (down.turned) {
      stop(down.state[0]);
    } else if (left <= 0) {
      stop(0);
    } else {
      state = {0, std::copysign(std::sqrt(left), down.state[1])};
    }
  }
  motion.peak_amplitude = peak * v0 / oscillator.p;
  motion.peak_acceleration = acceleration * v0 * oscillator.p;
  motion.stop_time = time / oscillator.p;
  return motion;
}

}  // namespace stillpoint::design
