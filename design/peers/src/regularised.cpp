// SPDX-License-Identifier: MIT

// The usual model without events, e the width as a speed, d as a length:
//   x' = v,   v' = -W - p^2 x - 2 zeta p v - (f + Delta bump(x)) tanh(v / e),
//   bump(x) = 1 / (2 d cosh^2(x / d)), whose integral is 1.
// A notch with a width is not a bump but a step of f, like a zone. A notch holds what its bump
// holds, so the model has no hold, nor a friction at rest that is larger than f.
// It creeps where the mass should be held, so rests are read off a band |v| < 3 e: tanh 3 = 0.995
// counts as held. A turn is an entry into the band or a change of sign of v
// across it, a stick an entry under a load that friction can hold. A passage leads from beyond
// the bump to beyond it on the other side; a rest within it is not a turn. The bump acts once
// the mass has been beyond it: a start at x = 0 is not a passage.

#include "dopri5.hpp"

#include <stillpoint/peers/ground.hpp>
#include <stillpoint/peers/methods.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::peers {

namespace {

template <class Load>
class SmoothRun {
 public:
  SmoothRun(const Scene& scene, const Load& load, double width, const Size& size, std::int64_t most)
      : scene_(scene),
        load_(load),
        stiffness_(scene.oscillator.p * scene.oscillator.p),
        damping_(2 * scene.oscillator.zeta * scene.oscillator.p),
        ground_(scene),
        method_(width * 1e-3, size),
        e_(width * size.speed),
        d_(width * size.length),
        most_steps_(most) {}

  Result run() {
    State state{scene_.start.x0, scene_.start.v0};
    const auto motion = [this](const State& now, State& rate, double t) {
      const double held = friction(now[0]) * std::tanh(now[1] / e_);
      rate = {now[1], -load_(t) - stiffness_ * now[0] - damping_ * now[1] - held};
    };
    result_.peak = std::abs(state[0]);
    at_rest_ = slow(state);
    side_ = side(state);
    double t = 0;
    bool jumped = true;
    while (t < scene_.t_end && result_.steps < most_steps_ && !(at_rest_ && settled(state))) {
      while (load_.stretch_end() <= t) {
        jumped = load_.next_stretch() || jumped;
      }
      if (jumped) {
        method_.begin(motion, t, state);
        jumped = false;
      }
      const double limit = std::min({load_.stretch_end(), scene_.t_end, t + reach(state)});
      const Step step = method_.step(motion, limit);
      t = step.to;
      if (state[1] * method_.state()[1] < 0) {
        const auto speed = [&](double when) { return method_.at(motion, when)[1]; };
        const double top = bracketed_root(speed, step.from, step.to);
        result_.peak = std::max(result_.peak, std::abs(method_.at(motion, top)[0]));
      }
      observe(state, method_.state(), t);
      state = method_.state();
    }
    result_.outcome = outcome(state);
    result_.finished = t >= scene_.t_end || result_.outcome != Outcome::running;
    result_.end_time = result_.outcome == Outcome::running ? t : entered_;
    result_.x = state[0];
    result_.v = state[1];
    return result_;
  }

 private:
  [[nodiscard]] double slowest() const { return 3 * e_; }
  [[nodiscard]] double edge() const { return 3 * d_; }

  [[nodiscard]] bool slow(const State& state) const { return std::abs(state[1]) < slowest(); }

  /// On which side of x = 0 the mass is; 0 within the bump.
  [[nodiscard]] int side(const State& state) const {
    const double beyond = ground_.notch() > 0 ? edge() : 0;
    return state[0] > beyond ? 1 : state[0] < -beyond ? -1 : 0;
  }

  [[nodiscard]] double friction(double x) const {
    const double f = ground_.friction(std::abs(x));
    if (side_ == 0 || ground_.notch() == 0) {
      return f;
    }
    const double c = std::cosh(std::min(std::abs(x) / d_, 300.0));
    return f + scene_.oscillator.delta / (2 * d_ * c * c);
  }

  /// The longest step that cannot jump over the bump or a step of f.
  [[nodiscard]] double reach(const State& state) const {
    const double speed = std::hypot(state[1], scene_.oscillator.p * state[0]);
    return std::max(d_, ground_.from_change(std::abs(state[0])) / 2) / std::max(speed, slowest());
  }

  [[nodiscard]] bool held(const State& state, double t) const {
    return std::abs(load_(t) + stiffness_ * state[0]) <= friction(state[0]);
  }

  /// A mass at rest that no load will ever move.
  [[nodiscard]] bool settled(const State& state) const {
    return load_.largest() + std::abs(stiffness_ * state[0]) <= friction(state[0]);
  }

  [[nodiscard]] Outcome outcome(const State& state) const {
    if (!at_rest_ || !settled(state)) {
      return Outcome::running;
    }
    const bool in_bump = ground_.notch() > 0 && std::abs(state[0]) < edge();
    return ground_.rest_at(in_bump ? 0 : state[0]);
  }

  void observe(const State& before, const State& now, double t) {
    ++result_.steps;
    result_.peak = std::max(result_.peak, std::abs(now[0]));
    const bool enters = slow(now) && !at_rest_;
    if (enters) {
      entered_ = t;
      result_.sticks += !settled(now) && held(now, t) ? 1 : 0;
    }
    const bool flies_over = !slow(now) && !at_rest_ && before[1] * now[1] < 0;
    const bool in_bump = ground_.notch() > 0 && side(now) == 0;
    result_.turns += (enters || flies_over) && !in_bump ? 1 : 0;
    if (const int where = side(now); where != 0) {
      result_.passages += where == -side_ ? 1 : 0;
      side_ = where;
    }
    at_rest_ = slow(now);
    ground_.reach(std::abs(now[0]));
    if (at_rest_) {
      ground_.rest();
    }
  }

  const Scene& scene_;
  Load load_;
  double stiffness_;
  double damping_;
  Ground ground_;
  Dopri5 method_;
  double e_;
  double d_;
  std::int64_t most_steps_;
  bool at_rest_{true};
  int side_{0};
  double entered_{0};
  Result result_;
};

}  // namespace

Result regularised(const Scene& scene, double width, const Size& size, std::int64_t most) {
  return with_load(scene.excitation, [&](const auto& load) {
    return SmoothRun(scene, load, width, size, most).run();
  });
}

}  // namespace stillpoint::peers
