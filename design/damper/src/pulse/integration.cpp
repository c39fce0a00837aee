// SPDX-License-Identifier: MIT

// In units of k and p: x'' = -W - s f - x, s = sgn x' on each slide, W the load of a pulse with
// k = p = 1. A slide is also cut where the pulse ends.

#include "pulse/integration.hpp"

#include "check/bracketed_root.hpp"

#include <stillpoint/core/elementary.hpp>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stillpoint::design {

namespace {

using State = std::array<double, 2>;  // x, v

struct Load {
  double lambda;
  double ends;
  bool flat;

  /// While the pulse lasts; smooth beyond its end, where a step may look.
  [[nodiscard]] double during(double t) const {
    return flat ? 1 : elementary::sin_cos(lambda * t).sine;
  }
};

Load load_of(const Pulse& pulse, double p) {
  const double lambda = angular_frequency(pulse) / p;
  const double angle = std::holds_alternative<FullSine>(pulse) ? 2 : 1;
  return {lambda, angle * std::numbers::pi / lambda, std::holds_alternative<Rectangle>(pulse)};
}

enum class SlideEnd { turn, arrival, pulse_ends };

class Run {
 public:
  Run(const Load& load, double f, double size, double tolerance)
      : load_(load), f_(f), absolute_(tolerance * size), relative_(tolerance) {}

  double time{0};
  State state{0, 0};
  double peak{0};
  double acceleration{0};

  /// At rest until the load exceeds friction; false where it never does.
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
  SlideEnd slide() {
    const bool loaded = time < load_.ends;
    const double force = (loaded ? load_.during(time) : 0) + state[0];
    const double ahead = (loaded && state[1] == 0 && std::abs(force) <= f_)
                             ? (load_.during(time + load_.ends * 1e-9) + state[0])
                             : force;
    const double direction = std::copysign(1.0, state[1] != 0 ? state[1] : -ahead);
    const auto motion = [&](const State& now, State& rate, double t) {
      rate = {now[1], -(loaded ? load_.during(t) : 0) - direction * f_ - now[0]};
    };
    auto stepper = boost::numeric::odeint::make_dense_output(
        absolute_, relative_, boost::numeric::odeint::runge_kutta_dopri5<State>());
    constexpr double part = 1e-4;  // of the pulse, or of 1 / p; the controller mends it at once
    stepper.initialize(state, time, part * std::min(1.0, load_.ends));
    const bool inward = state[0] * direction < 0;
    for (;;) {
      const auto [from, to] = stepper.do_step(motion);
      const auto at = [&stepper](double t) {
        State now;
        stepper.calc_state(t, now);
        return now;
      };
      const double last = loaded ? std::min(to, load_.ends) : to;
      State rate;
      motion(at(last), rate, last);
      acceleration = std::max(acceleration, std::abs(rate[1]));
      const bool turned = at(last)[1] * direction <= 0;
      const double turn =
          turned ? bracketed_root([&](double t) { return at(t)[1] * direction; }, from, last)
                 : last;
      time = turn;
      if (inward && at(turn)[0] * direction >= 0) {
        time = bracketed_root([&](double t) { return at(t)[0]; }, from, turn);
        state = at(time);
        return SlideEnd::arrival;
      }
      if (turned || last < to || (loaded && to >= load_.ends)) {
        state = at(time);
        peak = std::max(peak, std::abs(state[0]));
        if (turned) {
          state[1] = 0;
        }
        return turned ? SlideEnd::turn : SlideEnd::pulse_ends;
      }
    }
  }

 private:
  Load load_;
  double f_;
  double absolute_;
  double relative_;
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
    const SlideEnd end = run.slide();
    moving = end == SlideEnd::pulse_ends && run.state[1] != 0;
    if (end == SlideEnd::arrival) {
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
