// SPDX-License-Identifier: MIT
#include "pulse/sine_slide.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design {

namespace {

using std::numbers::pi;

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

namespace {

struct Taylor {
  double value;
  double slope;
  double curvature;
};

/// A step of this part of the time is the last one: it leaves an error of its cube.
constexpr double settled_step = 1e-6;
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
  for (int i = 0; i < most_steps; ++i) {
    const Taylor here = figure(now.motion);
    const double step = step_of(here);
    if (std::abs(here.value) <= settled_step * now.h * std::abs(here.slope)) {
      now.h += step;
      now.motion = slide.at(now.h);
      return now;
    }
    (here.value > 0 ? positive : other) = now.h;
    const double next = now.h + step;
    now.h = (next - positive) * (next - other) < 0 ? next : positive + (other - positive) / 2;
    now.motion = slide.at(now.h);
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
      now = {to, slide.at(to)};
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
        if (step <= settled_step * to) {
          return turned_or_arrived({to + step, slide.at(to + step)});
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
