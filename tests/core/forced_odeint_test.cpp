// SPDX-License-Identifier: MIT
#define BOOST_TEST_MODULE forced_odeint
#include "support/forced_scene.hpp"

#include <boost/numeric/odeint.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

// Random harmonic scenes against Boost.Odeint's dopri5 with dense output, events bracketed on a
// fine grid and bisected: nothing in common with the kernel but the rules.

namespace stillpoint::test {

namespace {

using OdeState = std::array<double, 2>;

// dopri5 at 1e-13 a step, over some hundreds of steps, and errors that the motion itself enlarges.
constexpr double metric_tolerance = 1e-8;
// What that leaves undecided.
constexpr double decided_margin = 1e-6;

class Integrated {
 public:
  Integrated(const Scene<>& scene, const Harmonic<>& wave) : scene_(scene), wave_(wave) {}

  double x{0};
  double v{0};
  int passages{0};
  int turns{0};
  int sticks{0};

  void run(double t_end) {
    x = scene_.x0;
    v = scene_.v0;
    if (x == 0 && v != 0 && v * v < 2 * scene_.delta) {
      v = 0;
      return;
    }
    direction_ = v > 0 ? 1 : -1;
    resting_ = v == 0;
    while (t_ < t_end && !held_) {
      resting_ ? rest(t_end) : slide(t_end);
    }
  }

 private:
  [[nodiscard]] double w(double t) const {
    return wave_.k * std::sin(wave_.lambda * t + wave_.phase);
  }
  [[nodiscard]] double load(double t) const { return w(t) + scene_.p * scene_.p * x; }

  void rest(double t_end) {
    const double step = 1e-3 / wave_.lambda;
    const double begin = t_;
    while (t_ < t_end && std::abs(load(t_)) <= scene_.f) {
      t_ += step;
    }
    if (t_ > begin) {
      double low = t_ - step;
      for (int i = 0; i < 60; ++i) {
        const double middle = low + (t_ - low) / 2;
        (std::abs(load(middle)) <= scene_.f ? low : t_) = middle;
      }
      ++sticks;
    }
    t_ = std::min(t_, t_end);
    resting_ = false;
    direction_ = load(t_) > 0 ? -1 : 1;
    v = 0;
  }

  void slide(double t_end) {
    namespace odeint = boost::numeric::odeint;
    const double s = direction_;
    const auto motion = [&](const OdeState& state, OdeState& rate, double t) {
      rate = {state[1], -w(t) - scene_.p * scene_.p * state[0] - s * scene_.f};
    };
    auto stepper = odeint::make_dense_output(1e-14, 1e-13, odeint::runge_kutta_dopri5<OdeState>());
    stepper.initialize(OdeState{x, v}, t_, 1e-4 / std::max(wave_.lambda, scene_.p));
    const bool inward = s * x < 0;
    while (t_ < t_end) {
      const auto [from, to] = stepper.do_step(motion);
      const double end = std::min(to, t_end);
      const auto at = [&](double t) {
        OdeState state;
        stepper.calc_state(t, state);
        return state;
      };
      constexpr int looks = 32;
      for (int look = 1; look <= looks; ++look) {
        const double t = look == looks ? end : from + (end - from) * look / looks;
        const OdeState state = at(t);
        if (inward && s * state[0] >= 0 && scene_.delta > 0) {
          return arrive(bisected(t_, t, [&](double when) { return s * at(when)[0] < 0; }), at);
        }
        if (s * state[1] < 0) {
          t_ = bisected(t_, t, [&](double when) { return s * at(when)[1] >= 0; });
          return turn(at(t_)[0], inward);
        }
        t_ = t;
      }
    }
    OdeState state;
    stepper.calc_state(t_, state);
    passages += inward && s * state[0] >= 0 ? 1 : 0;
    x = state[0];
    v = state[1];
  }

  template <class Before>
  static double bisected(double low, double high, Before before) {
    for (int i = 0; i < 60; ++i) {
      const double middle = low + (high - low) / 2;
      (before(middle) ? low : high) = middle;
    }
    return high;
  }

  template <class At>
  void arrive(double t, At at) {
    t_ = t;
    const double speed = at(t)[1];
    x = 0;
    const double left = speed * speed - 2 * scene_.delta;
    held_ = left <= 0;
    v = held_ ? 0 : direction_ * std::sqrt(left);
    passages += held_ ? 0 : 1;
  }

  void turn(double where, bool inward) {
    passages += inward && direction_ * where >= 0 ? 1 : 0;
    x = where;
    v = 0;
    ++turns;
    resting_ = true;
  }

  Scene<> scene_;
  Harmonic<> wave_;
  double t_{0};
  int direction_{1};
  bool resting_{false};
  bool held_{false};
};

}  // namespace

BOOST_AUTO_TEST_CASE(an_independent_integrator_sees_the_same_motion) {
  Dice dice(40401);
  int compared = 0;
  double worst = 0;
  while (compared < 60) {
    ForcedScene<> scene = random_forced_scene(dice);
    auto* wave = std::get_if<Harmonic<>>(&scene.excitation);
    if (wave == nullptr || std::isfinite(wave->duration)) {
      continue;
    }
    scene.t_end = std::min(scene.t_end, 25 / scene.motion.p);
    const ForcedState<double> kernel = run_forced(scene).state;
    if (!kernel.margin.any() || kernel.margin.value() < decided_margin) {
      continue;
    }
    ++compared;
    Integrated other(scene.motion, *wave);
    other.run(scene.t_end);
    BOOST_TEST_CONTEXT(scene) {
      const bool rests =
          kernel.mode == ForcedMode::resting && kernel.rest_begin.high() < kernel.now.high();
      BOOST_TEST(other.passages == kernel.passages);
      BOOST_TEST(other.turns == kernel.turning_points);
      BOOST_TEST(std::abs(static_cast<double>(other.sticks - kernel.sticks)) <=
                 (rests || kernel.outcome ? 1 : 0));
      const double size = std::max({kernel.farthest, std::abs(kernel.u), std::abs(kernel.v)});
      const double off =
          std::max(std::abs(other.x * scene.motion.p - kernel.u), std::abs(other.v - kernel.v)) /
          (size > 0 ? size : 1);
      BOOST_TEST(off <= metric_tolerance);
      worst = std::max(worst, off);
    }
  }
  BOOST_TEST_MESSAGE(compared << " scenes, worst difference " << worst);
}

}  // namespace stillpoint::test
