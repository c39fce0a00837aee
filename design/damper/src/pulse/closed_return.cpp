// SPDX-License-Identifier: MIT
#include "pulse/closed_return.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

// | here   | means                                                                 |
// |--------|-----------------------------------------------------------------------|
// | y, v   | -x and -x': the pulse moves the mass towards y > 0                     |
// | c      | where the friction alone would hold the mass, -f outwards, f inwards   |
// | h      | the time since a slide began                                          |
// | psi    | lambda t, the phase of the load sin psi                                |

namespace stillpoint::design {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double crest = 1.5 * pi;  // of a full sine's second half

struct Moving {
  double y{0};
  double v{0};
};

/// (62): a slide under sin(psi + lambda h), about c.
class SineSlide {
 public:
  SineSlide(double lambda, double psi, double c, Moving start)
      : lambda_(lambda), psi_(psi), begin_(elementary::sin_cos(psi)), c_(c), s_(start) {}

  [[nodiscard]] Moving at(double h) const {
    const auto [half, half_cosine] = elementary::sin_cos(h / 2);
    const double bend = 2 * half * half;  // 1 - cos h
    const double sine = 2 * half * half_cosine;
    const Moving by_load = loaded(h, sine, 1 - bend);
    return {s_.y + (c_ - s_.y) * bend + s_.v * sine + by_load.y,
            (c_ - s_.y) * sine + s_.v * (1 - bend) + by_load.v};
  }
  [[nodiscard]] double acceleration(double h, double y) const {
    return elementary::sin_cos(psi_ + lambda_ * h).sine + c_ - y;
  }

 private:
  /// What the load adds to a mass at rest; near resonance by the form that does not divide by it.
  [[nodiscard]] Moving loaded(double h, double sine_h, double cosine_h) const {
    constexpr double far_from_resonance = 2;
    const double psi = psi_ + lambda_ * h;
    if (lambda_ >= far_from_resonance) {
      const double scale = 1 / ((lambda_ - 1) * (lambda_ + 1));
      const auto [sine, cosine] = elementary::sin_cos(psi);
      return {(lambda_ * sine_h * begin_.cosine + cosine_h * begin_.sine - sine) * scale,
              (lambda_ * (cosine_h * begin_.cosine - cosine) - sine_h * begin_.sine) * scale};
    }
    const double a = (lambda_ + 1) / 2 * h;
    const double b = (lambda_ - 1) / 2 * h;
    const auto sinc = [](double z) { return z == 0 ? 1 : elementary::sin_cos(z).sine / z; };
    const double fast = sinc(a);
    const double slow = sinc(b);
    const elementary::SinCos at_a = elementary::sin_cos(a + psi_);
    const elementary::SinCos at_b = elementary::sin_cos(b + psi_);
    return {h / 2 * (fast * at_b.cosine - slow * at_a.cosine),
            h / 2 * (slow * at_a.sine + fast * at_b.sine)};
  }

  double lambda_;
  double psi_;
  elementary::SinCos begin_;
  double c_;
  Moving s_;
};

/// The zero of a function with its slope, between a place where it is positive and one where it is
/// not: Newton's steps, or halves where they leave the bracket. A step of this part of the place
/// squares the error below rounding.
template <class Function>
double zero(double positive, double other, const Function& function) {
  constexpr double last_step = 1e-8;
  constexpr int enough = 100;
  double now = positive + (other - positive) / 2;
  for (int i = 0; i < enough; ++i) {
    const auto [value, slope] = function(now);
    (value > 0 ? positive : other) = now;
    const double newton = now - value / slope;
    if (std::abs(newton - now) <= last_step * now) {
      return newton;
    }
    now = (newton - positive) * (newton - other) < 0 ? newton : positive + (other - positive) / 2;
  }
  return now;
}

/// The motion so far, and how it goes on when the load is over.
class Outcome {
 public:
  explicit Outcome(double f) { motion_.f = f; }

  void turn(double y) {
    motion_.turns += 1;
    motion_.peak = std::max(motion_.peak, y);
  }
  /// At rest for ever.
  [[nodiscard]] FirstReturn rest(double y) {
    motion_.clearance = y * (y - 2 * motion_.f);
    return finished();
  }
  [[nodiscard]] FirstReturn arrival(double speed, double time, double load_after = 0) {
    motion_.returns = true;
    motion_.speed = speed;
    motion_.clearance = speed * speed;
    motion_.time = time;
    motion_.acceleration = load_after;
    return finished();
  }
  /// Free from a turn at y.
  [[nodiscard]] FirstReturn free_from(double y, double time) {
    return y > motion_.f ? free_inwards({y, 0}, time) : rest(y);
  }
  /// Free with v <= 0, (64).
  [[nodiscard]] FirstReturn free_inwards(const Moving& now, double time) {
    const double f = motion_.f;
    const double square = now.v * now.v + now.y * (now.y - 2 * f);
    if (!(square > 0)) {
      motion_.turns += 1;
      motion_.clearance = square;
      return finished();
    }
    const double speed = std::sqrt(square);
    return arrival(speed,
                   time + elementary::atan2(speed, -f) - elementary::atan2(-now.v, now.y - f));
  }
  /// Free with v > 0, (63).
  [[nodiscard]] FirstReturn free_outwards(const Moving& now, double time) {
    const double f = motion_.f;
    const double radius = elementary::hypot(now.v, now.y + f);
    const double peak = (now.v * now.v + now.y * (now.y + 2 * f)) / (radius + f);
    turn(peak);
    return free_from(peak, time + elementary::atan2(now.v, now.y + f));
  }

 private:
  [[nodiscard]] FirstReturn finished() {
    motion_.acceleration = std::max(motion_.acceleration, motion_.f + motion_.peak);
    motion_.exact_need = motion_.speed * motion_.speed / 2;
    motion_.published_need = motion_.exact_need + motion_.f * motion_.f / 2;
    return motion_;
  }

  FirstReturn motion_;
};

/// Half-swings about 1 - f outwards and 1 + f inwards, each of the length pi.
FirstReturn under_rectangle(double lambda, double f) {
  Outcome outcome(f);
  const double ends = pi / lambda;
  double from = 0;  // of a half-swing
  double y = 0;
  bool outwards = true;
  for (;;) {
    const double centre = outwards ? 1 - f : 1 + f;
    const double h = ends - from;
    if (h <= pi) {
      const auto [half, half_cosine] = elementary::sin_cos(h / 2);
      const Moving now{y + 2 * (centre - y) * half * half, 2 * (centre - y) * half * half_cosine};
      return outwards ? outcome.free_outwards(now, ends) : outcome.free_inwards(now, ends);
    }
    y = 2 * centre - y;
    from += pi;
    outcome.turn(y);
    outwards = !outwards;
    if ((outwards ? 1 - y : y - 1) <= f) {  // held until the load ends
      return outcome.free_from(y, ends);
    }
  }
}

/// Inwards from where the mass has turned, at rest at y when the phase is psi, until the load of
/// the phase `last` ends: empty if it turns again.
std::optional<FirstReturn> back_under_sine(Outcome& outcome, double lambda, double f, double y,
                                           double psi, double last) {
  const SineSlide slide(lambda, psi, f, {y, 0});
  const double end = (last - psi) / lambda;
  const Moving then = slide.at(end);
  if (!(then.v < 0)) {
    return std::nullopt;
  }
  if (then.y > 0) {
    return outcome.free_inwards({then.y, then.v}, last / lambda);
  }
  const double h = zero(0, end, [&](double now) {
    const Moving at = slide.at(now);
    return std::pair(at.y, at.v);
  });
  const double phase = psi + lambda * h;
  const double load = last > crest && phase < crest ? 1 : std::abs(elementary::sin_cos(phase).sine);
  return outcome.arrival(-slide.at(h).v, phase / lambda, load);
}

std::optional<FirstReturn> under_sine(double lambda, double f, double last) {
  Outcome outcome(f);
  const double release = elementary::asin(f);
  const SineSlide slide(lambda, release, -f, {});
  // In each stretch v crosses 0 once at most, and only if it is negative at the end: (65), (66).
  double from = pi / 2;
  double to = std::min(last, crest);
  Moving then = slide.at((to - release) / lambda);
  if (then.v > 0 && to < last) {
    from = to;
    to = last;
    then = slide.at((to - release) / lambda);
  }
  if (then.v > 0) {
    return outcome.free_outwards(then, last / lambda);
  }
  const double h = zero((from - release) / lambda, (to - release) / lambda, [&](double now) {
    const Moving at = slide.at(now);
    return std::pair(at.v, slide.acceleration(now, at.y));
  });
  const double y = slide.at(h).y;
  const double turned = release + lambda * h;
  outcome.turn(y);
  if (y - elementary::sin_cos(turned).sine > f) {
    return back_under_sine(outcome, lambda, f, y, turned, last);
  }
  // Held until sin psi = y - f, while the load still turns against it.
  if (turned >= crest || y - f <= (last > pi ? -1 : 0)) {
    return outcome.rest(y);
  }
  return back_under_sine(outcome, lambda, f, y, std::max(turned, pi - elementary::asin(y - f)),
                         last);
}

}  // namespace

std::optional<FirstReturn> closed_return(const Pulse& pulse, double f) {
  const double lambda = angular_frequency(pulse);
  if (!(f < 1)) {
    return std::nullopt;
  }
  if (std::holds_alternative<Rectangle>(pulse)) {
    return under_rectangle(lambda, f);
  }
  const bool full = std::holds_alternative<FullSine>(pulse);
  // A full sine that is short leaves a velocity that is a difference of its two halves.
  constexpr double short_sine = 1e3;
  if (lambda < (full ? 1 : 0.5) || (full && lambda > short_sine)) {
    return std::nullopt;
  }
  return under_sine(lambda, f, full ? 2 * pi : pi);
}

}  // namespace stillpoint::design
