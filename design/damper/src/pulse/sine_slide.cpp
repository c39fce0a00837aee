// SPDX-License-Identifier: MIT
#include "pulse/sine_slide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace stillpoint::design {

namespace {

using std::numbers::pi;

/// 1/n, from n = 1.
constexpr std::array reciprocal{0.0,     1.0,     1.0 / 2, 1.0 / 3, 1.0 / 4,
                                1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8};

struct Swing {
  double sine;
  double bend;  ///< 1 - cosine
};

Swing doubled(const elementary::SinCos& half) {
  return {2 * half.sine * half.cosine, 2 * half.sine * half.sine};
}

}  // namespace

SlideMotion SineSlide::at(double h) const {
  const elementary::SinCos half = elementary::sin_cos(h / 2);
  const elementary::SinCos half_load = elementary::sin_cos(lambda_ * h / 2);
  const Swing own = doubled(half);
  const Swing of_load = doubled(half_load);
  const double rise = begin_.cosine * of_load.sine - begin_.sine * of_load.bend;
  const double cosine = begin_.cosine * (1 - of_load.bend) - begin_.sine * of_load.sine;
  SlideMotion now{y_ + (c_ - y_) * own.bend, (c_ - y_) * own.sine};
  if (is_resonant_) {
    add_near_resonance(now, h, half, half_load);
  } else {
    now.y += over_square_ * (lambda_ * own.sine * begin_.cosine - own.bend * begin_.sine - rise);
    now.v += over_square_ *
             (lambda_ * ((1 - own.bend) * begin_.cosine - cosine) - own.sine * begin_.sine);
  }
  now.a = begin_.sine + rise + c_ - now.y;
  now.j = lambda_ * cosine - now.v;
  return now;
}

void SineSlide::add_near_resonance(SlideMotion& now, double h, const elementary::SinCos& own,
                                   const elementary::SinCos& of_load) const {
  const double b = (lambda_ - 1) / 2 * h;
  const double sine_a = of_load.sine * own.cosine + of_load.cosine * own.sine;
  const double cosine_a = of_load.cosine * own.cosine - of_load.sine * own.sine;
  const auto [sine_b, cosine_b] = elementary::sin_cos(b);
  const double fast = sine_a / (lambda_ + 1);  // times 2, as slow
  const double slow = b == 0 ? h / 2 : sine_b / (lambda_ - 1);
  const auto& [sine, cosine] = begin_;
  now.y += fast * (cosine_b * cosine - sine_b * sine) - slow * (cosine_a * cosine - sine_a * sine);
  now.v += slow * (sine_a * cosine + cosine_a * sine) + fast * (sine_b * cosine + cosine_b * sine);
}

/// Eight terms, good to a rounding within 1/16 of 1 and of 1/lambda. The load and its slope are
/// those of the motion: sin psi = a - c + y, lambda cos psi = j + v. A short full sine leaves a
/// small difference of speeds, which has no digits to spare.
SlideMotion SineSlide::near(double h, SlideMoment& last) const {
  constexpr double part = 1.0 / 16;
  const double d = h - last.h;
  constexpr double short_sine = 100;
  if (!(std::abs(d) * std::max(1.0, lambda_) <= part && lambda_ <= short_sine)) {
    last = {h, at(h)};
    return last.motion;
  }
  constexpr std::size_t terms = 8;
  const auto& [y, v, a, j] = last.motion;
  std::array<double, terms + 2> rate{y, v, a, j};
  std::array<double, 2> load{a - c_ + y, j + v};
  for (std::size_t n = 2; n + 2 < rate.size(); ++n) {
    load[n % 2] *= -lambda_ * lambda_;
    rate[n + 2] = load[n % 2] - rate[n];
  }
  const auto sum = [&](std::size_t first, std::size_t count) {
    double value = 0;
    for (std::size_t n = count; n > 0; --n) {
      value = d * reciprocal[n] * (rate[first + n] + value);
    }
    return rate[first] + value;
  };
  constexpr std::size_t steer = 6;  // a and j only say where to search next, to 1e-10
  return {sum(0, terms), sum(1, terms), sum(2, steer), sum(3, steer)};
}

namespace {

struct Taylor {
  double value;
  double slope;
  double curvature;
};

/// A step of this part of the time is the last one: it leaves an error of its cube.
constexpr double last_step = 1e-6;
/// The most steps to a zero, even if it is double or lost in rounding.
constexpr int most_steps = 100;

/// To where the parabola falls through 0, by Halley's formula where it does not reach it.
double step_of(const Taylor& figure) {
  const auto [value, slope, curvature] = figure;
  const double square = slope * slope - 2 * value * curvature;
  return square >= 0 ? 2 * value / (std::sqrt(square) - slope)
                     : 2 * value * slope / (value * curvature - 2 * slope * slope);
}

/// The parabola's next zero is far beyond this one, and its error is small compared with the slope.
bool is_near(const Taylor& figure, double step) {
  return step <= std::min(1.0, -figure.slope) / 4 &&
         std::abs(figure.value * figure.curvature) <= figure.slope * figure.slope / 4;
}

/// The zero of a quantity of the motion between a time when it is positive and one when it is not.
template <class Figure>
SlideMoment zero(const SineSlide& slide, double positive, const SlideMoment& not_positive,
                 const Figure& figure) {
  double other = not_positive.h;
  SlideMoment now = not_positive;
  SlideMoment last = not_positive;
  for (int i = 0; i < most_steps; ++i) {
    const Taylor here = figure(now.motion);
    const double step = step_of(here);
    if (std::abs(here.value) <= last_step * now.h * std::abs(here.slope)) {
      now.h += step;
      now.motion = slide.near(now.h, last);
      return now;
    }
    (here.value > 0 ? positive : other) = now.h;
    const double next = now.h + step;
    now.h = (next - positive) * (next - other) < 0 ? next : positive + (other - positive) / 2;
    now.motion = slide.near(now.h, last);
  }
  return now;
}

}  // namespace

/// The speed u is followed by quarters of the load, u'' + u >= 0 in those that drive it:
/// docs/theory.md (65).
Slid slid(const SineSlide& slide, bool outwards, double last) {
  const double sign = outwards ? 1 : -1;
  const auto speed = [sign](const SlideMotion& m) {
    return Taylor{sign * m.v, sign * m.a, sign * m.j};
  };
  const auto height = [](const SlideMotion& m) { return Taylor{m.y, m.v, m.a}; };
  const auto turned_or_arrived = [&](const SlideMoment& turn) {
    return turn.motion.y > 0 ? Slid{SlideEvent::turn, turn}
                             : Slid{SlideEvent::arrival, zero(slide, 0, turn, height)};
  };
  double from = 0;
  double step = pi;
  SlideMoment now{-HUGE_VAL, {}};
  SlideMoment known = now;
  for (const double quarter : {pi / 2, LoadPhase::second_crest, 2 * pi}) {
    const double end = slide.time_to(std::min(quarter, last));
    const bool driven = (quarter == LoadPhase::second_crest) != outwards;
    for (int i = 0; from < end && i < most_steps; ++i) {
      const double to = std::min(from + step, end);
      if (driven && to == end) {  // u > 0
        from = end;
        step = pi / 2;  // at most pi, where it usually turns
        break;
      }
      now = {to, slide.near(to, known)};
      const Taylor here = speed(now.motion);
      const double u = here.value;
      if (!outwards && now.motion.y <= 0 && u >= 0) {
        return {SlideEvent::arrival, zero(slide, 0, now, height)};
      }
      if (u <= 0) {
        return turned_or_arrived(zero(slide, from, now, speed));
      }
      from = to;
      // The next zero of u'' + u = 0 is no farther than Newton's step.
      if (here.slope < 0 && is_near(here, -u / here.slope)) {
        step = step_of(here);
        if (step <= last_step * to) {
          return turned_or_arrived({to + step, slide.near(to + step, known)});
        }
      } else {
        step = elementary::atan2(u, -here.slope);
      }
    }
  }
  if (now.h != from) {
    now = {from, slide.at(from)};
  }
  return !outwards && now.motion.y <= 0 ? Slid{SlideEvent::arrival, zero(slide, 0, now, height)}
                                        : Slid{SlideEvent::load_over, now};
}

}  // namespace stillpoint::design
