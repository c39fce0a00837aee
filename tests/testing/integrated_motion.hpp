// SPDX-License-Identifier: MIT
#pragma once

// A forced motion by Boost.Odeint's dopri5 with dense output; events are found on a fine grid and
// bisected. It shares only the rules with the kernel.

#include "testing/forced_scene.hpp"

#include <boost/numeric/odeint.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace stillpoint::test {

/// A stretch of time on which W is smooth, and its formula, which may be used a little beyond.
struct SmoothLoad {
  double end;
  double scale;  ///< a time in which W changes little when divided by a thousand
  std::function<double(double)> w;
};

/// In order, from tau = 0 without end.
inline std::vector<SmoothLoad> smooth_loads(const AnyExcitation<double>& excitation) {
  static constexpr double for_ever = std::numeric_limits<double>::infinity();
  const auto nothing = [](double /*t*/) { return 0.0; };
  std::vector<SmoothLoad> list;
  const auto wave = [&](double k, double lambda, double phase, double lasts) {
    list.push_back({lasts, 1 / lambda, [=](double t) { return k * std::sin(lambda * t + phase); }});
  };
  struct Make {
    std::vector<SmoothLoad>& list;
    const decltype(wave)& add_wave;

    void operator()(const NoExcitation& /*none*/) const {}
    void operator()(const Harmonic& e) const {
      add_wave(e.k, e.lambda, e.phase, e.duration.value_or(for_ever));
    }
    void operator()(const HalfSine& e) const {
      add_wave(e.k, e.lambda, 0, std::acos(-1.0) / e.lambda);
    }
    void operator()(const FullSine& e) const {
      add_wave(e.k, e.lambda, 0, 2 * std::acos(-1.0) / e.lambda);
    }
    void operator()(const Rectangle& e) const {
      list.push_back({std::acos(-1.0) / e.lambda, 1 / e.lambda, [e](double /*t*/) { return e.k; }});
    }
    void operator()(const Record& e) const {
      const auto time = [&](std::size_t i) {
        return e.times.empty() ? static_cast<double>(i) * e.step : e.times[i];
      };
      list.push_back({time(0), 1, [](double /*t*/) { return 0.0; }});
      for (std::size_t i = 0; i + 1 < e.values.size(); ++i) {
        const double begin = time(i);
        const double length = time(i + 1) - begin;
        list.push_back(
            {time(i + 1), length, [=, from = e.values[i], to = e.values[i + 1]](double t) {
               return from + (to - from) * ((t - begin) / length);
             }});
      }
    }
  };
  std::visit(Make{list, wave}, excitation);
  list.push_back({for_ever, 1, nothing});
  return list;
}

class IntegratedMotion {
 public:
  /// `size` of x and v, for the absolute tolerance.
  IntegratedMotion(const ForcedScene<>& scene, double size)
      : scene_(scene.motion),
        hold_(scene.hold),
        surface_(scene.surface),
        loads_(smooth_loads(scene.excitation)),
        size_(size) {
    if (surface_.notch_width) {
      wall_ = scene_.delta / *surface_.notch_width;
      scene_.delta = 0;
      edges_.push_back(*surface_.notch_width / 2);
    }
    for (const FrictionZone& zone : surface_.zones) {
      edges_.push_back(zone.to);
    }
    std::sort(edges_.begin(), edges_.end());
  }

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
      if (!hold_) {
        return;
      }
    }
    leaving_ = surface_.notch_width && x == 0 && v != 0;
    moved_ = v != 0;
    direction_ = v > 0 ? 1 : -1;
    resting_ = v == 0;
    for (const SmoothLoad& load : loads_) {
      load_ = &load;
      const double end = std::min(load.end, t_end);
      while (t_ < end && !held_) {
        resting_ ? rest(end) : slide(end);
      }
    }
    if (resting_ && !held_) {
      count_stick();
    }
  }

 private:
  using State = std::array<double, 2>;

  [[nodiscard]] double load(double t) const { return load_->w(t) + scene_.p * scene_.p * x; }

  /// The bisection of a rest that ends at once leaves some rounding of its length.
  void count_stick() { sticks += scene_.p * (t_ - rest_begin_) > 1e-12 ? 1 : 0; }

  /// Friction just beyond |x| = place.
  [[nodiscard]] double friction_at(double place) const {
    double f = scene_.f;
    for (std::size_t i = surface_.zones.size(); i > 0; --i) {
      f = place < surface_.zones[i - 1].to ? surface_.zones[i - 1].f : f;
    }
    const bool walled = surface_.notch_width && place < *surface_.notch_width / 2 && !leaving_;
    return walled ? f + wall_ : f;
  }

  /// Friction against a motion from x in the direction s.
  [[nodiscard]] double friction_towards(double s) const {
    const double y = s * x;
    return friction_at(y >= 0 ? y : std::nextafter(-y, 0.0));
  }

  /// The next |x| of the law on the way, as s x; infinite where there is none.
  [[nodiscard]] double edge_towards(double s) const {
    const double y = s * x;
    double next = y < 0 ? 0 : std::numeric_limits<double>::infinity();
    for (const double edge : edges_) {
      for (const double there : {-edge, edge}) {
        next = there > y ? std::min(next, there) : next;
      }
    }
    return next;
  }

  [[nodiscard]] bool held(double t) const {
    const bool notched = scene_.delta > 0 && x == 0 && hold_;
    const double now = load(t);
    return std::abs(now) <= friction_towards(now > 0 ? -1 : 1) + (notched ? *hold_ : 0);
  }

  void rest(double end) {
    const double step = std::min({1e-3 * load_->scale, (end - t_) / 8, 0.1 / scene_.p});
    double before = t_;
    while (t_ < end && held(t_)) {
      before = t_;
      t_ = std::min(t_ + step, end);
    }
    if (held(t_)) {
      return;
    }
    if (t_ > before) {
      t_ = bisected(before, t_, [&](double t) { return held(t); });
    }
    count_stick();
    resting_ = false;
    direction_ = load(t_) > 0 ? -1 : 1;
    v = 0;
    passages += moved_ && x == 0 && scene_.delta > 0 ? 1 : 0;  // out of the notch
    moved_ = true;
  }

  void slide(double end) {
    namespace odeint = boost::numeric::odeint;
    const double s = direction_;
    const double f = friction_towards(s);
    const double edge = edge_towards(s);
    const auto motion = [&](const State& state, State& rate, double t) {
      rate = {state[1], -load_->w(t) - scene_.p * scene_.p * state[0] - s * f};
    };
    auto stepper =
        odeint::make_dense_output(1e-14 * size_, 1e-13, odeint::runge_kutta_dopri5<State>());
    stepper.initialize(State{x, v}, t_, std::min({1e-4 * load_->scale, 1e-4 / scene_.p, end - t_}));
    while (t_ < end) {
      const auto [from, to] = stepper.do_step(motion);
      const double until = std::min(to, end);
      const auto at = [&](double t) {
        State state;
        stepper.calc_state(t, state);
        return state;
      };
      constexpr int looks = 32;
      for (int look = 1; look <= looks; ++look) {
        const double t = look == looks ? until : from + (until - from) * look / looks;
        const State state = at(t);
        if (s * state[0] >= edge) {
          t_ = bisected(t_, t, [&](double when) { return s * at(when)[0] < edge; });
          return arrive(edge, at(t_)[1]);
        }
        if (s * state[1] < 0) {
          t_ = bisected(t_, t, [&](double when) { return s * at(when)[1] >= 0; });
          return turn(at(t_)[0]);
        }
        t_ = t;
      }
    }
    State state;
    stepper.calc_state(t_, state);
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

  void arrive(double edge, double speed) {
    x = direction_ * edge;
    v = speed;
    leaving_ = leaving_ && edge < *surface_.notch_width / 2;
    if (edge != 0) {
      return;
    }
    const double left = speed * speed - 2 * scene_.delta;
    if (left > 0) {
      v = direction_ * std::sqrt(left);
      ++passages;
      return;
    }
    v = 0;
    held_ = !hold_;
    resting_ = true;
    rest_begin_ = t_;
  }

  void turn(double where) {
    x = where;
    v = 0;
    leaving_ = false;
    ++turns;
    resting_ = true;
    rest_begin_ = t_;
  }

  Scene<> scene_;
  std::optional<double> hold_;
  Surface surface_;
  std::vector<double> edges_{};
  double wall_{0};  ///< of the notch
  bool leaving_{false};
  bool moved_{false};
  std::vector<SmoothLoad> loads_;
  double size_;
  const SmoothLoad* load_{nullptr};
  double t_{0};
  double rest_begin_{0};
  int direction_{1};
  bool resting_{false};
  bool held_{false};
};

}  // namespace stillpoint::test
