// SPDX-License-Identifier: MIT
#pragma once

// One motion by an integrator: the rules of docs/forced.md section 1 and docs/notches.md section 2
// around pieces in which the sign s of v and the friction f are constant,
//   x' = v,   v' = -W(t) - p^2 x - s f - 2 zeta p v.
// An event is found as users would do it: a change of sign over a step, then a bracketed root on
// the integrator's own states within the step.
//
// A Method integrates:
//   begin(motion, t, state)  a new piece, or after a jump of W
//   step(motion, limit)      one step, to `limit` at most; says where it ended and what it located
//   state()                  at the end of that step
//   at(motion, t)            within that step
//   locates_events           whether the integrator looks for turns and x = 0 itself; it then ends
//                            its steps at them, at() is not used, and scenes have no other edges
//   has_dense_output         whether at() is cheap
//   acceleration()           where it is known at no cost: v' at the end of the step

#include <stillpoint/peers/ground.hpp>
#include <stillpoint/peers/load.hpp>
#include <stillpoint/peers/methods.hpp>
#include <stillpoint/peers/scene.hpp>

#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace stillpoint::peers {

using State = std::array<double, 2>;  // x, v

/// x' = v, v' = -W(t) - p^2 x - s f - 2 zeta p v: what an integrator integrates while v keeps its
/// sign s.
template <class Load>
struct Motion {
  const Load& load;
  double stiffness;  // p^2
  double direction;  // s
  double friction;   // s f
  double damping;    // 2 zeta p

  /// What the structure feels.
  [[nodiscard]] double transmitted(const State& now) const {
    return stiffness * now[0] + friction + damping * now[1];
  }
  [[nodiscard]] State rate_of(const State& now, double w) const {
    return {now[1], -w - stiffness * now[0] - friction - damping * now[1]};
  }
  void operator()(const State& now, State& rate, double t) const { rate = rate_of(now, load(t)); }
};

/// The event that an integrator with its own event finder found at the end of a step.
enum class Located { nothing, turn, arrival };

struct Step {
  double from{0};
  double to{0};
  Located event{Located::nothing};
};

/// Where `function` changes its sign in [from, to], to the last bit; `to` if it does not. It may
/// vanish at `from`, where a piece begins at rest: that root does not count.
template <class Function>
double bracketed_root(const Function& function, double from, double to) {
  const double at_to = function(to);
  double low = from;
  double at_low = function(from);
  for (int halvings = 1; at_low == 0 && halvings < 40; ++halvings) {
    low = from + std::ldexp(to - from, -halvings);
    const double there = function(low);
    at_low = there * at_to < 0 ? there : 0;
  }
  if (!(at_low * at_to < 0)) {
    return to;
  }
  std::uintmax_t most_evaluations = 100;
  return boost::math::tools::toms748_solve(function, low, to, at_low, at_to,
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .second;
}

/// The same by Newton's method kept within the bracket, for methods whose states within a step cost
/// as much as a step: `function` gives the value and its rate. Boost's method trusts the direction
/// of the rate, so a value that moves away from 0 at first is left to bisection.
template <class Function>
double newton_root(const Function& function, double from, double to) {
  const auto [at_from, rate_from] = function(from);
  const auto [at_to, rate_to] = function(to);
  if (!(at_from * at_to < 0 && at_from * rate_from < 0)) {
    return bracketed_root([&](double t) { return function(t).first; }, from, to);
  }
  std::uintmax_t most_evaluations = 50;
  const double chord = -at_from * (to - from) / (at_to - at_from);
  // Half of the digits of the time since `from`: Newton's last step doubles them.
  return from + boost::math::tools::newton_raphson_iterate(
                    [&](double since) { return function(from + since); }, chord, 0.0, to - from,
                    std::numeric_limits<double>::digits / 2, most_evaluations);
}

template <class Load, class Method>
class EventRun {
 public:
  EventRun(const Scene& scene, const Load& load, Method& method, std::int64_t most)
      : scene_(scene),
        load_(load),
        method_(method),
        effort_left_(most),
        stiffness_(scene.oscillator.p * scene.oscillator.p),
        damping_(2 * scene.oscillator.zeta * scene.oscillator.p),
        ground_(scene),
        notch_(ground_.notch()),
        state_{scene.start.x0, scene.start.v0} {}

  Result run() {
    begin();
    while (t_ < scene_.t_end && result_.outcome == Outcome::running && effort_left_ > 0) {
      if (resting_) {
        rest();
      } else {
        slide();
      }
    }
    finish();
    return result_;
  }

 private:
  [[nodiscard]] double& x() { return state_[0]; }
  [[nodiscard]] double& v() { return state_[1]; }
  [[nodiscard]] double load() const { return load_(t_) + stiffness_ * state_[0]; }
  [[nodiscard]] static double pushed_by(double load) { return load > 0 ? -1 : 1; }
  [[nodiscard]] bool holds(double load) const {
    return std::abs(load) <= ground_.capacity(pushed_by(load), state_[0]);
  }
  [[nodiscard]] bool held() const { return holds(load()); }
  /// At rest, and no load to come will ever move it: a harmonic one swings to +-k for ever.
  [[nodiscard]] bool held_for_ever() const {
    const double spring = stiffness_ * state_[0];
    return holds(spring + load_.largest()) && holds(spring - load_.largest());
  }

  void begin() {
    enter_stretch();
    if (x() == 0 && v() != 0 && holds_at_start(notch_ / 2, v())) {
      v() = 0;
      if (!ground_.lets_go()) {
        stop(Outcome::caught_at_start);
      }
    }
    moved_ = v() != 0;
    result_.peak = std::abs(x());
    resting_ = v() == 0;
    rest_begin_ = t_;
    direction_ = v() < 0 ? -1 : 1;
  }

  void stop(Outcome outcome) {
    result_.outcome = outcome;
    result_.end_time = t_;
  }

  void stop_where_it_rests() {
    t_ = rest_begin_;
    const bool caught = !moved_ && scene_.start.v0 != 0;
    stop(caught ? Outcome::caught_at_start : ground_.rest_at(x()));
  }

  void finish() {
    result_.finished = result_.outcome != Outcome::running || t_ >= scene_.t_end;
    if (!result_.finished) {
      result_.end_time = t_;
    } else if (result_.outcome == Outcome::running && resting_ && held_for_ever()) {
      stop_where_it_rests();
    } else if (result_.outcome == Outcome::running) {
      result_.end_time = t_;
      result_.sticks += resting_ && t_ > rest_begin_ ? 1 : 0;
    }
    result_.x = x();
    result_.v = v();
    result_.peak = std::max(result_.peak, std::abs(x()));
  }

  /// Moves to the stretch of W that contains t; returns whether W jumped.
  bool enter_stretch() {
    bool jumped = false;
    while (load_.stretch_end() <= t_) {
      jumped = load_.next_stretch() || jumped;
    }
    return jumped;
  }

  void rest() {
    if (!held()) {
      return set_off(pushed_by(load()));
    }
    if (held_for_ever()) {
      return stop_where_it_rests();
    }
    --effort_left_;
    const double from = t_;
    feel(load_(from));
    t_ = std::min({load_.next_look(t_), load_.stretch_end(), scene_.t_end});
    if (!held()) {
      const double s = pushed_by(load());
      const double limit = -s * ground_.capacity(s, x());
      const auto excess = [&](double t) { return load_(t) + stiffness_ * x() - limit; };
      const double root = bracketed_root(excess, from, t_);
      // A load that was at the limit exceeds it at once.
      t_ = root == t_ && excess(from) == 0 ? from : root;
      feel(load_(t_));
      enter_stretch();
      return set_off(s);
    }
    feel(load_(t_));
    enter_stretch();
  }

  void feel(double acceleration) {
    result_.acceleration = std::max(result_.acceleration, std::abs(acceleration));
  }

  void set_off(double s) {
    effort_left_ -= event_effort;
    result_.sticks += t_ > rest_begin_ ? 1 : 0;
    direction_ = s;
    resting_ = false;
    result_.passages += moved_ && x() == 0 && notch_ > 0 ? 1 : 0;  // out of the notch
    moved_ = true;
  }

  void slide() {
    const double s = direction_;
    const Motion<Load> motion{load_, stiffness_, s, s * ground_.friction_towards(s, x()), damping_};
    edge_ = ground_.edge_towards(s, x());
    method_.begin(motion, t_, state_);
    feel(motion.transmitted(state_));
    const bool inward = s * x() < 0;
    while (t_ < scene_.t_end && effort_left_ > 0) {
      const Step step = method_.step(motion, std::min(load_.stretch_end(), scene_.t_end));
      ++result_.steps;
      --effort_left_;
      const bool over = step_ends(motion, step, inward);
      if (over || damping_ > 0) {  // without, most is felt at an end
        feel(motion.transmitted(state_));
      }
      if (over) {
        return;
      }
      if (enter_stretch()) {
        method_.begin(motion, t_, state_);
      }
    }
    feel(motion.transmitted(state_));
    count_passage(inward);
  }

  /// Keeps the step up to the event in it; returns whether there was one.
  bool step_ends(const Motion<Load>& motion, const Step& step, bool inward) {
    const double s = direction_;
    t_ = step.to;
    state_ = method_.state();
    if constexpr (requires { method_.acceleration(); }) {
      result_.relative_acceleration =
          std::max(result_.relative_acceleration, std::abs(method_.acceleration()));
    }
    if constexpr (Method::locates_events) {
      if (step.event == Located::turn) {
        turn(inward);
      } else if (step.event == Located::arrival && edge_ == 0) {
        arrive();
      } else {
        return false;
      }
      return true;
    } else {
      const bool turned = s * v() <= 0 || turns_within(motion, step);
      if (!turned && !(s * x() >= edge_)) {
        return false;
      }
      if (turned) {
        locate(motion, 1, step.from, t_);
      }
      // If the motion turns within the step, its position there says whether it met the edge.
      if (s * x() >= edge_) {
        locate(motion, 0, step.from, t_);
        arrive();
      } else {
        turn(inward);
      }
      return true;
    }
  }

  /// v may vanish and come back within a step, which its signs at the ends do not show: it is least
  /// where the acceleration changes its sign. Then the step ends there.
  template <class AnyMotion>
  bool turns_within(const AnyMotion& motion, const Step& step) {
    if constexpr (requires { method_.acceleration_before(); }) {
      if (direction_ * method_.acceleration_before() < 0 &&
          direction_ * method_.acceleration() > 0) {
        const auto acceleration = [&](double t) {
          State rate;
          motion(method_.at(motion, t), rate, t);
          return rate[1];
        };
        const double least = bracketed_root(acceleration, step.from, step.to);
        const State there = method_.at(motion, least);
        if (direction_ * there[1] <= 0) {
          t_ = least;
          state_ = there;
          return true;
        }
      }
    }
    return false;
  }

  /// To where x comes to the edge (0) or v vanishes (1) within the step.
  void locate(const Motion<Load>& motion, std::size_t which, double from, double to) {
    const double level = which == 0 ? direction_ * edge_ : 0;
    if constexpr (Method::has_dense_output) {
      const auto value = [&](double t) { return method_.at(motion, t)[which] - level; };
      t_ = bracketed_root(value, from, to);
    } else {
      const auto value_and_rate = [&](double t) {
        const State now = method_.at(motion, t);
        State rate;
        motion(now, rate, t);
        return std::pair(now[which] - level, rate[which]);
      };
      t_ = newton_root(value_and_rate, from, to);
    }
    state_ = method_.at(motion, t_);
    if (damping_ > 0) {
      feel(motion.transmitted(state_));  // before the notch takes speed
    }
  }

  void count_passage(bool inward) { result_.passages += inward && direction_ * x() >= 0 ? 1 : 0; }

  void turn(bool inward) {
    effort_left_ -= event_effort;
    count_passage(inward);
    ++result_.turns;
    result_.peak = std::max(result_.peak, std::abs(x()));
    come_to_rest();
  }

  void come_to_rest() {
    v() = 0;
    ground_.rest();
    resting_ = true;
    rest_begin_ = t_;
    enter_stretch();
  }

  void arrive() {
    effort_left_ -= event_effort;
    x() = edge_ == 0 ? 0 : direction_ * edge_;
    ground_.reach(edge_);
    if (edge_ == 0) {
      result_.arrival_speed = std::abs(v());
      const double left = v() * v() - notch_;
      if (left <= 0 && !ground_.lets_go()) {
        v() = 0;
        feel(load_(t_));
        return stop(Outcome::stopped_at_zero);
      }
      if (left <= 0) {
        return come_to_rest();
      }
      v() = direction_ * std::sqrt(left);
      ++result_.passages;
    }
    enter_stretch();
  }

  static constexpr std::int64_t event_effort = 10;  // about the effort of a bracketed root

  const Scene& scene_;
  Load load_;
  Method& method_;
  std::int64_t effort_left_;
  double stiffness_;
  double damping_;
  Ground ground_;
  double notch_;
  double edge_{0};  ///< s x where the piece ends
  State state_;
  double t_{0};
  double direction_{1};
  bool resting_{false};
  bool moved_{false};
  double rest_begin_{0};
  Result result_;
};

/// The motion of `scene` by `method`, which may take an effort of `most` (methods.hpp).
template <class Method>
Result run_events(const Scene& scene, Method& method, std::int64_t most = usual_effort) {
  return with_load(scene.excitation,
                   [&](const auto& load) { return EventRun(scene, load, method, most).run(); });
}

}  // namespace stillpoint::peers
