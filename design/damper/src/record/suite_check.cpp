// SPDX-License-Identifier: MIT

// x'' = -W - p^2 x - s phi between events: s is the sign of x', phi the friction at x.

#include "record/suite_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace stillpoint::design {

namespace {

/// Of the phase p t. The error of a step is (p h)^5/120 of the motion, so 5e-16 for each radian:
/// close decisions amplify it up to a millionfold. A slip as short as a step is off by
/// (p h)^2/20 of itself, so 1e-8.
constexpr double phase_step = 1.0 / 2000;
/// Twice the half-cycles that a suite allows, with the pieces between the edges of a notch.
constexpr std::int64_t most_pieces_after_the_record = 80'000;
/// Per step: it leaves 1e-15 of it.
constexpr int halvings = 50;

/// |c| - phi <= 1e-13 of their terms: a load equal to the friction holds the mass.
constexpr double load_rounding = 1e-13;

constexpr double never = std::numeric_limits<double>::infinity();

using State = std::array<double, 2>;  // x, x'

/// W between two samples, or 0 outside them. Times count from the start of the stretch: if counted
/// from the start of the record, their rounding would be the largest error.
struct Stretch {
  double length{never};
  double from{0};
  double slope{0};

  [[nodiscard]] double load(double t) const { return from + slope * t; }
};

class Integration {
 public:
  Integration(const Oscillator& oscillator, const Surface& surface)
      : stiffness_(oscillator.p * oscillator.p),
        step_(phase_step / oscillator.p),
        f_(oscillator.f),
        hold_(oscillator.hold) {
    if (surface.notch_width) {
      half_width_ = *surface.notch_width / 2;
      wall_ = oscillator.delta / *surface.notch_width;
    } else {
      notch_ = 2 * oscillator.delta;
    }
  }

  SuiteFigures run(const Record& record) {
    if (!record.times.empty()) {
      follow({record.times.front(), 0, 0});
    }
    for (std::size_t i = 0; i + 1 < record.values.size(); ++i) {
      const double length =
          record.times.empty() ? record.step : record.times[i + 1] - record.times[i];
      follow({length, record.values[i], (record.values[i + 1] - record.values[i]) / length});
    }
    rest_after_the_load({});
    return result_;
  }

 private:
  /// Friction against a motion from x in the direction s.
  [[nodiscard]] double friction(double s) const {
    const double y = s * state_[0];
    return y >= -half_width_ && y < half_width_ ? f_ + wall_ : f_;
  }
  /// The next s x at which the law changes.
  [[nodiscard]] double edge(double s) const {
    const double y = s * state_[0];
    if (half_width_ > 0 && y < half_width_) {
      return y < -half_width_ ? -half_width_ : half_width_;
    }
    return half_width_ == 0 && notch_ > 0 && y < 0 ? 0 : never;
  }

  /// Up to the end of the stretch, or of the motion after it.
  void follow(const Stretch& stretch) {
    t_ = 0;
    while (t_ < stretch.length && !locked_) {
      resting_ ? rest(stretch) : slide(stretch);
    }
    if (locked_) {
      feel_load(stretch, t_, stretch.length);
    }
  }

  void rest_after_the_load(const Stretch& stretch) {
    t_ = 0;
    for (std::int64_t piece = 0; piece < most_pieces_after_the_record; ++piece) {
      if (resting_ && (locked_ || std::abs(stiffness_ * state_[0]) <= capacity(-state_[0]))) {
        result_.settled = true;
        result_.residual = std::abs(state_[0]);
        return;
      }
      resting_ ? set_off(-state_[0]) : slide(stretch);
    }
  }

  /// The load that the mass is held against when pushed in the direction `push`.
  [[nodiscard]] double capacity(double push) const {
    const bool in_notch = notch_ > 0 && state_[0] == 0 && hold_;
    return friction(push < 0 ? -1 : 1) + (in_notch ? *hold_ : 0);
  }

  void feel_load(const Stretch& stretch, double from, double to) {
    result_.acceleration =
        std::max({result_.acceleration, std::abs(stretch.load(from)), std::abs(stretch.load(to))});
  }

  /// Until the load exceeds what holds the mass; it is linear, so this is a division.
  void rest(const Stretch& stretch) {
    const double now = stretch.load(t_) + stiffness_ * state_[0];
    const double size = std::abs(stretch.load(t_)) + std::abs(now) + capacity(-now);
    if (std::abs(now) - capacity(-now) > load_rounding * size) {
      return set_off(-now);
    }
    const double then = stretch.load(stretch.length) + stiffness_ * state_[0];
    const double most = capacity(-then);
    double until = stretch.length;
    if (std::abs(then) > most) {
      until = t_ + (std::copysign(most, then) - now) / stretch.slope;
      until = std::clamp(until, t_, stretch.length);
    }
    feel_load(stretch, t_, until);
    t_ = until;
    if (std::abs(then) > most) {
      set_off(-then);
    }
  }

  void set_off(double push) {
    direction_ = push < 0 ? -1 : 1;
    resting_ = false;
    feel_slide(friction(direction_));
  }

  void feel_slide(double phi) {
    result_.peak = std::max(result_.peak, std::abs(state_[0]));
    result_.acceleration =
        std::max(result_.acceleration, std::abs(direction_ * stiffness_ * state_[0] + phi));
  }

  [[nodiscard]] double acceleration(const Stretch& stretch, double phi, double t,
                                    const State& at) const {
    return -stretch.load(t) - stiffness_ * at[0] - direction_ * phi;
  }

  /// One step of length h from here.
  [[nodiscard]] State stepped(const Stretch& stretch, double phi, double h) const {
    const auto rate = [&](double t, const State& at) {
      return State{at[1], acceleration(stretch, phi, t, at)};
    };
    const auto moved = [&](const State& by, double length) {
      return State{state_[0] + length * by[0], state_[1] + length * by[1]};
    };
    const State k1 = rate(t_, state_);
    const State k2 = rate(t_ + h / 2, moved(k1, h / 2));
    const State k3 = rate(t_ + h / 2, moved(k2, h / 2));
    const State k4 = rate(t_ + h, moved(k3, h));
    const auto mean = [&](std::size_t i) { return (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]) / 6; };
    return {state_[0] + h * mean(0), state_[1] + h * mean(1)};
  }

  /// The end of [0, h] up to which `holds`, by halving.
  template <class Holds>
  static double last(double h, const Holds& holds) {
    double low = 0;
    for (int i = 0; i < halvings; ++i) {
      const double middle = low + (h - low) / 2;
      (holds(middle) ? low : h) = middle;
    }
    return h;
  }

  /// To the next turn, edge, or the end of the stretch.
  void slide(const Stretch& stretch) {
    const double s = direction_;
    const double phi = friction(s);
    const double limit = edge(s);
    while (t_ < stretch.length) {
      const double room = stretch.length - t_;
      const bool last_step = room <= step_;
      const double whole = last_step ? room : step_;
      double h = whole;
      State next = stepped(stretch, phi, h);
      // Where the mass slows down and speeds up again, it may have turned in between; not where it
      // sets off, when rounding may make its acceleration negative.
      if (s * state_[1] > 0 && s * next[1] >= 0 && s * acceleration(stretch, phi, t_, state_) < 0 &&
          s * acceleration(stretch, phi, t_ + h, next) > 0) {
        const double slowest = last(h, [&](double part) {
          const State there = stepped(stretch, phi, part);
          return s * acceleration(stretch, phi, t_ + part, there) < 0;
        });
        const State there = stepped(stretch, phi, slowest);
        if (s * there[1] < 0) {
          h = slowest;
          next = there;
        }
      }
      const bool turned = s * next[1] < 0;
      if (turned) {
        h = last(h, [&](double part) { return s * stepped(stretch, phi, part)[1] >= 0; });
        next = stepped(stretch, phi, h);
      }
      const bool arrived = s * next[0] >= limit;
      if (arrived) {
        h = last(h, [&](double part) { return s * stepped(stretch, phi, part)[0] < limit; });
        next = stepped(stretch, phi, h);
      }
      t_ = last_step && h == whole ? stretch.length : t_ + h;
      state_ = next;
      feel_slide(phi);
      if (arrived) {
        return arrive(s * limit);
      }
      if (turned) {
        state_[1] = 0;
        resting_ = true;
        return;
      }
    }
  }

  void arrive(double place) {
    state_[0] = place;
    if (notch_ == 0 || place != 0) {
      return feel_slide(friction(direction_));  // beyond the edge
    }
    const double left = state_[1] * state_[1] - notch_;
    resting_ = left <= 0;
    locked_ = resting_ && !hold_;
    state_[1] = resting_ ? 0 : direction_ * std::sqrt(left);
  }

  double stiffness_;
  double step_;
  double f_;
  std::optional<double> hold_;
  double half_width_{0};
  double wall_{0};
  double notch_{0};  // 2 Delta of a notch without a width
  State state_{};
  double t_{0};  // since the stretch began
  double direction_{1};
  bool resting_{true};
  bool locked_{false};
  SuiteFigures result_{.settled = false};
};

}  // namespace

SuiteFigures integrate_record_motion(const Oscillator& oscillator, const Surface& surface,
                                     const Record& record) {
  return Integration(oscillator, surface).run(record);
}

}  // namespace stillpoint::design
