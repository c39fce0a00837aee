// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/peers/event_run.hpp>

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stillpoint::peers {

/// The error of a step over the allowed error, as in odeint's own checker, but with an absolute
/// tolerance for each of x and v.
class SizedErrorChecker {
 public:
  using value_type = double;

  SizedErrorChecker(double tolerance, const Size& size)
      : tolerance_(tolerance), size_{size.length, size.speed} {}

  template <class Algebra, class Time>
  double error(Algebra& /*algebra*/, const State& state, const State& rate, const State& error,
               Time step) const {
    double most = 0;
    for (std::size_t i = 0; i < error.size(); ++i) {
      const double scale = size_[i] + (std::abs(state[i]) + std::abs(step) * std::abs(rate[i]));
      most = std::max(most, std::abs(error[i]) / (tolerance_ * scale));
    }
    return most;
  }

 private:
  double tolerance_;
  State size_;
};

/// odeint's rule for the next step, with a power that is the same on every machine.
class StepAdjuster : public boost::numeric::odeint::default_step_adjuster<double, double> {
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

/// What odeint::make_dense_output does, with steps that can be told to end at a kink: from one to
/// the next the last derivative of a step stays the first of the next.
class Dopri5 {
 public:
  static constexpr bool locates_events = false;
  static constexpr bool has_dense_output = true;

  Dopri5(double tolerance, const Size& size)
      : controlled_(SizedErrorChecker(tolerance, size), StepAdjuster()), next_(1e-2 * size.time) {}

  template <class AnyMotion>
  void begin(const AnyMotion& motion, double t, const State& state) {
    now_ = {t, state, {}};
    motion(now_.state, now_.rate, t);
  }

  template <class AnyMotion>
  Step step(const AnyMotion& motion, double limit) {
    std::swap(before_, now_);
    for (;;) {
      const double room = limit - before_.t;
      const bool capped = next_ >= room;
      double length = capped ? room : next_;
      now_.t = before_.t;
      const auto verdict = controlled_.try_step(motion, before_.state, before_.rate, now_.t,
                                                now_.state, now_.rate, length);
      if (verdict == boost::numeric::odeint::success) {
        // A step that a kink cut short says little about the next one.
        next_ = capped ? std::max(next_, length) : length;
        now_.t = capped ? limit : now_.t;
        return {before_.t, now_.t};
      }
      next_ = length;
    }
  }

  [[nodiscard]] const State& state() const { return now_.state; }
  [[nodiscard]] double acceleration() const { return now_.rate[1]; }
  [[nodiscard]] double acceleration_before() const { return before_.rate[1]; }

  template <class AnyMotion>
  State at(const AnyMotion& /*motion*/, double t) {
    State state;
    controlled_.stepper().calc_state(t, state, before_.state, before_.rate, before_.t, now_.state,
                                     now_.rate, now_.t);
    return state;
  }

 private:
  using Dopri = boost::numeric::odeint::runge_kutta_dopri5<State>;
  struct Point {
    double t{0};
    State state{};
    State rate{};
  };

  boost::numeric::odeint::controlled_runge_kutta<Dopri, SizedErrorChecker, StepAdjuster>
      controlled_;
  Point before_;
  Point now_;
  double next_;
};

}  // namespace stillpoint::peers
