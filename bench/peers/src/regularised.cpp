// SPDX-License-Identifier: MIT

// The model without events that people write first, e the width:
//   x' = v,   v' = -W - p^2 x - (f + Delta bump(x)) tanh(v / e),
//   bump(x) = 1 / (2 e cosh^2(x / e)), whose integral is 1.
// It creeps where the mass should be held, so what it says of rests is read off a band |v| < 3 e:
// tanh 3 = 0.995 is as good as held. A turn is an entry into the band, a stick one under a load
// that friction can hold.

#include <stillpoint/peers/event_run.hpp>
#include <stillpoint/peers/methods.hpp>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::peers {

namespace {

namespace odeint = boost::numeric::odeint;

template <class Load>
class SmoothRun {
 public:
  SmoothRun(const Scene& scene, const Load& load, double width, std::int64_t most_steps)
      : scene_(scene),
        load_(load),
        stiffness_(scene.oscillator.p * scene.oscillator.p),
        width_(width),
        most_steps_(most_steps) {}

  Result run() {
    State state{scene_.start.x0, scene_.start.v0};
    auto stepper =
        odeint::make_controlled(width_ * 1e-3, width_ * 1e-3, odeint::runge_kutta_dopri5<State>());
    const auto motion = [this](const State& now, State& rate, double t) {
      rate = {now[1],
              -load_(t) - stiffness_ * now[0] - friction(now[0]) * std::tanh(now[1] / width_)};
    };
    at_rest_ = std::abs(state[1]) < band();
    double t = 0;
    double next = width_;
    while (t < scene_.t_end && result_.steps < most_steps_ && !(at_rest_ && settled(state, t))) {
      while (load_.stretch_end() <= t) {
        load_.next_stretch();
      }
      const double limit = std::min({load_.stretch_end(), scene_.t_end, t + reach(state)});
      const bool capped = next >= limit - t;
      double length = capped ? limit - t : next;
      const double x = state[0];
      if (stepper.try_step(motion, state, t, length) == odeint::success) {
        next = capped ? std::max(next, length) : length;
        t = capped ? limit : t;
        observe(x, state, t);
      } else {
        next = length;
      }
    }
    result_.outcome = outcome(state, t);
    result_.end_time = result_.outcome == Outcome::running ? t : entered_;
    result_.x = state[0];
    result_.v = state[1];
    return result_;
  }

 private:
  [[nodiscard]] double band() const { return 3 * width_; }

  [[nodiscard]] double friction(double x) const {
    const double c = std::cosh(std::min(std::abs(x) / width_, 300.0));
    return scene_.oscillator.f + scene_.oscillator.delta / (2 * width_ * c * c);
  }

  /// How far a step may go without jumping over the bump.
  [[nodiscard]] double reach(const State& state) const {
    if (scene_.oscillator.delta == 0) {
      return for_ever;
    }
    const double speed = std::hypot(state[1], scene_.oscillator.p * state[0]);
    return std::max(width_, std::abs(state[0]) / 2) / std::max(speed, band());
  }

  [[nodiscard]] bool held(const State& state, double t) const {
    return std::abs(load_(t) + stiffness_ * state[0]) <= friction(state[0]);
  }

  /// A mass at rest that no load will ever move.
  [[nodiscard]] bool settled(const State& state, double t) const {
    return load_.over() && held(state, t);
  }

  [[nodiscard]] Outcome outcome(const State& state, double t) const {
    if (!at_rest_ || !settled(state, t)) {
      return Outcome::running;
    }
    const bool in_notch = scene_.oscillator.delta > 0 && std::abs(state[0]) < band();
    return in_notch ? Outcome::stopped_at_zero : Outcome::stopped_in_dead_zone;
  }

  void observe(double x_before, const State& state, double t) {
    ++result_.steps;
    result_.peak = std::max(result_.peak, std::abs(state[0]));
    const bool slow = std::abs(state[1]) < band();
    if (slow && !at_rest_) {
      entered_ = t;
      ++result_.turns;
      result_.sticks += !load_.over() && held(state, t) ? 1 : 0;
    } else if (!slow && x_before != 0 && x_before * state[0] <= 0) {
      ++result_.passages;
    }
    at_rest_ = slow;
  }

  const Scene& scene_;
  Load load_;
  double stiffness_;
  double width_;
  std::int64_t most_steps_;
  bool at_rest_{true};
  double entered_{0};
  Result result_;
};

}  // namespace

Result regularised(const Scene& scene, double width, std::int64_t most_steps) {
  return with_load(scene.excitation, [&](const auto& load) {
    return SmoothRun(scene, load, width, most_steps).run();
  });
}

}  // namespace stillpoint::peers
