// SPDX-License-Identifier: MIT
#include "pulse/closed_return.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

// | here   | means                                                                 |
// |--------|-----------------------------------------------------------------------|
// | y, v   | -x and -x': the pulse moves the mass towards y > 0                     |
// | c      | where the friction alone would hold the mass, -f outwards, f inwards   |
// | h      | the time since a slide began                                          |
// | psi    | lambda t, the phase of the load sin psi                                |
// | ByF    | derivatives over f, (68)                                               |

namespace stillpoint::design {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double crest = 1.5 * pi;  // of a full sine's second half

/// 1/n, from n = 1.
constexpr std::array reciprocal{0.0,     1.0,     1.0 / 2, 1.0 / 3, 1.0 / 4,
                                1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8};

struct Moving {
  double y{0};
  double v{0};
  double a{0};  ///< v'
  double j{0};  ///< v''
};

/// An instant of a slide.
struct Moment {
  double h{0};
  Moving motion;
};

/// Of a place and a speed at a given time.
struct ByF {
  double y{0};
  double v{0};
};

/// Of where and when a slide begins.
struct BeginByF {
  double y{0};
  double t{0};
};

/// A phase of the load with its sine and cosine.
struct Phase {
  double psi{0};
  elementary::SinCos of{0, 1};
};

/// (62): a slide from rest under sin(psi + lambda h), about c.
class SineSlide {
 public:
  SineSlide(double lambda, const Phase& begin, double c, double y)
      : lambda_(lambda),
        over_square_(1 / ((lambda - 1) * (lambda + 1))),
        psi_(begin.psi),
        begin_(begin.of),
        c_(c),
        y_(y) {}

  [[nodiscard]] Moving at(double h) const {
    const elementary::SinCos half = elementary::sin_cos(h / 2);
    const elementary::SinCos half_load = elementary::sin_cos(lambda_ * h / 2);
    const Swing own = doubled(half);
    const Swing of_load = doubled(half_load);
    const double rise = begin_.cosine * of_load.sine - begin_.sine * of_load.bend;
    const double cosine = begin_.cosine * (1 - of_load.bend) - begin_.sine * of_load.sine;
    Moving now{y_ + (c_ - y_) * own.bend, (c_ - y_) * own.sine};
    constexpr double near = 1.0 / 16;
    if (std::abs(lambda_ - 1) < near) {
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
  /// The same by Taylor's series, if h is close to the last instant that was not computed by it.
  [[nodiscard]] Moving near(double h, Moment& last) const;
  /// (68), with c moving by `sign`.
  [[nodiscard]] ByF by_f(double h, double sign, const BeginByF& begin) const {
    const auto [sine, cosine] = elementary::sin_cos(h);
    const double kick = (begin_.sine + c_ - y_) * begin.t;
    return {sign + (begin.y - sign) * cosine - kick * sine,
            (sign - begin.y) * sine - kick * cosine};
  }
  [[nodiscard]] double time_to(double psi) const { return (psi - psi_) / lambda_; }
  [[nodiscard]] double phase(double h) const { return psi_ + lambda_ * h; }

 private:
  struct Swing {
    double sine;
    double bend;  ///< 1 - cosine
  };
  static Swing doubled(const elementary::SinCos& half) {
    return {2 * half.sine * half.cosine, 2 * half.sine * half.sine};
  }
  /// By the form that does not divide by lambda^2 - 1.
  void add_near_resonance(Moving& now, double h, const elementary::SinCos& own,
                          const elementary::SinCos& of_load) const {
    const double b = (lambda_ - 1) / 2 * h;
    const double sine_a = of_load.sine * own.cosine + of_load.cosine * own.sine;
    const double cosine_a = of_load.cosine * own.cosine - of_load.sine * own.sine;
    const auto [sine_b, cosine_b] = elementary::sin_cos(b);
    const double fast = sine_a / (lambda_ + 1);  // times 2, as slow
    const double slow = b == 0 ? h / 2 : sine_b / (lambda_ - 1);
    const auto& [sine, cosine] = begin_;
    now.y +=
        fast * (cosine_b * cosine - sine_b * sine) - slow * (cosine_a * cosine - sine_a * sine);
    now.v +=
        slow * (sine_a * cosine + cosine_a * sine) + fast * (sine_b * cosine + cosine_b * sine);
  }

  double lambda_;
  double over_square_;  ///< 1/(lambda^2 - 1)
  double psi_;
  elementary::SinCos begin_;
  double c_;
  double y_;
};

/// Eight terms, good to a rounding within 1/16 of 1 and of 1/lambda. The load and its slope are
/// those of the motion: sin psi = a - c + y, lambda cos psi = j + v. A short full sine leaves a
/// small difference of speeds, which has no digits to spare.
Moving SineSlide::near(double h, Moment& last) const {
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
Moment zero(const SineSlide& slide, double positive, const Moment& not_positive,
            const Figure& figure) {
  double other = not_positive.h;
  Moment now = not_positive;
  Moment last = not_positive;
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

enum class SlideEvent { turn, arrival, load_over };

struct Slid {
  SlideEvent event{SlideEvent::load_over};
  Moment at;
};

/// The first event of a slide from rest until the load of the phase `last` ends. The speed u is
/// followed by quarters of the load, u'' + u >= 0 in those that drive it: docs/theory.md (65).
Slid slid(const SineSlide& slide, bool outwards, double last) {
  const double sign = outwards ? 1 : -1;
  const auto speed = [sign](const Moving& m) { return Taylor{sign * m.v, sign * m.a, sign * m.j}; };
  const auto height = [](const Moving& m) { return Taylor{m.y, m.v, m.a}; };
  const auto turned_or_arrived = [&](const Moment& turn) {
    return turn.motion.y > 0 ? Slid{SlideEvent::turn, turn}
                             : Slid{SlideEvent::arrival, zero(slide, 0, turn, height)};
  };
  double from = 0;
  double step = pi;
  Moment now;
  Moment known{-HUGE_VAL, {}};
  for (const double quarter : {pi / 2, crest, 2 * pi}) {
    const double end = slide.time_to(std::min(quarter, last));
    const bool driven = (quarter == crest) != outwards;
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

/// The motion so far, and how it continues when the load is over.
class MotionSoFar {
 public:
  explicit MotionSoFar(double f) { motion_.f = f; }

  void turn(double y) {
    motion_.turns += 1;
    motion_.peak = std::max(motion_.peak, y);
  }
  void turn_inwards(double y, double acceleration) {
    turn(y);
    motion_.shortfall = std::min(motion_.shortfall, 2 * acceleration * y);
  }
  /// At rest for ever.
  [[nodiscard]] FirstReturn rest(double y) {
    motion_.clearance = y * (y - 2 * motion_.f);
    return finished();
  }
  [[nodiscard]] FirstReturn arrival(double speed, double time, double need_slope,
                                    double load_after = 0) {
    motion_.returns = true;
    motion_.speed = speed;
    motion_.clearance = speed * speed;
    motion_.time = time;
    motion_.need_slope = need_slope;
    motion_.acceleration = load_after;
    return finished();
  }
  /// Free from a turn at y.
  [[nodiscard]] FirstReturn free_from(double y, double time, double by_f) {
    return y > motion_.f ? free_inwards({y, 0}, time, {by_f, 0}) : rest(y);
  }
  /// Free with v <= 0, (64).
  [[nodiscard]] FirstReturn free_inwards(const Moving& now, double time, const ByF& by_f) {
    const double f = motion_.f;
    const double square = now.v * now.v + now.y * (now.y - 2 * f);
    if (!(square > 0)) {
      motion_.turns += 1;
      motion_.clearance = square;
      return finished();
    }
    const double speed = std::sqrt(square);
    return arrival(speed,
                   time + elementary::atan2(speed, -f) - elementary::atan2(-now.v, now.y - f),
                   now.v * by_f.v + (now.y - f) * by_f.y - now.y);
  }
  /// Free with v > 0, (63).
  [[nodiscard]] FirstReturn free_outwards(const Moving& now, double time, const ByF& by_f) {
    const double f = motion_.f;
    const double radius = elementary::hypot(now.v, now.y + f);
    const double peak = (now.v * now.v + now.y * (now.y + 2 * f)) / (radius + f);
    turn(peak);
    return free_from(peak, time + elementary::atan2(now.v, now.y + f),
                     (now.v * by_f.v + (now.y + f) * (by_f.y + 1)) / radius - 1);
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
  MotionSoFar so_far(f);
  const double ends = pi / lambda;
  double from = 0;  // of a half-swing
  double y = 0;
  double by_f = 0;
  bool outwards = true;
  for (;;) {
    const double sign = outwards ? -1 : 1;
    const double centre = 1 + sign * f;
    const double h = ends - from;
    if (h <= pi) {
      const auto [half, half_cosine] = elementary::sin_cos(h / 2);
      const double bend = 2 * half * half;
      const double sine = 2 * half * half_cosine;
      const Moving now{y + (centre - y) * bend, (centre - y) * sine};
      const ByF now_by_f{by_f + (sign - by_f) * bend, (sign - by_f) * sine};
      return outwards ? so_far.free_outwards(now, ends, now_by_f)
                      : so_far.free_inwards(now, ends, now_by_f);
    }
    y = 2 * centre - y;
    by_f = 2 * sign - by_f;
    from += pi;
    so_far.turn(y);
    outwards = !outwards;
    if ((outwards ? 1 - y : y - 1) <= f) {  // held until the load ends
      return so_far.free_from(y, ends, by_f);
    }
  }
}

/// The phase of that sine before or after the crest at pi/2.
Phase phase_of(double sine, bool after) {
  const double cosine = std::sqrt((1 - sine) * (1 + sine));
  return after ? Phase{pi - elementary::asin(sine), {sine, -cosine}}
               : Phase{elementary::asin(sine), {sine, cosine}};
}

/// When a mass that has turned starts again.
struct Release {
  Phase begin;
  bool outwards;
};

/// For a mass that has turned at y; empty if it is held for ever. If it has hardly moved, it was on
/// the edge of being held, where rounding would let it start again and again.
std::optional<Release> release_of(double f, double y, double psi, double last, bool moved) {
  const Phase now{psi, elementary::sin_cos(psi)};
  const double load = now.of.sine;
  if (moved && std::abs(y - load) > f) {
    return Release{now, load > y};
  }
  const auto not_before_now = [&](const Phase& then) { return then.psi > psi ? then : now; };
  if (psi < pi / 2 && y + f < 1) {
    return Release{not_before_now(phase_of(y + f, false)), true};
  }
  if (psi >= crest || y - f <= (last > pi ? -1 : 0)) {
    return std::nullopt;
  }
  return Release{not_before_now(phase_of(y - f, true)), false};
}

std::optional<FirstReturn> under_sine(double lambda, double f, double last) {
  MotionSoFar so_far(f);
  double y = 0;
  BeginByF begin;
  Release release{phase_of(f, false), true};
  // For a pulse of a hundred natural periods. Rounding could hold a mass on the edge of a slide.
  constexpr int most_slides = 1000;
  for (int i = 0; i < most_slides; ++i) {
    const bool outwards = release.outwards;
    const double sign = outwards ? -1 : 1;
    const SineSlide slide(lambda, release.begin, sign * f, y);
    const auto [event, at] = slid(slide, outwards, last);
    const ByF by_f = slide.by_f(at.h, sign, begin);
    if (event == SlideEvent::load_over) {
      return outwards ? so_far.free_outwards(at.motion, last / lambda, by_f)
                      : so_far.free_inwards(at.motion, last / lambda, by_f);
    }
    const double psi = slide.phase(at.h);
    if (event == SlideEvent::arrival) {
      const double load = psi < last - pi / 2 ? 1 : std::abs(elementary::sin_cos(psi).sine);
      return so_far.arrival(-at.motion.v, psi / lambda, at.motion.v * by_f.v - at.motion.a * by_f.y,
                            load);
    }
    y = at.motion.y;
    if (outwards) {
      so_far.turn(y);
    } else {
      so_far.turn_inwards(y, at.motion.a);
    }
    constexpr double rounding = 1e-14;
    const auto next = release_of(f, y, psi, last, psi - release.begin.psi > rounding);
    if (!next) {
      return so_far.rest(y);
    }
    // What is held sets out where nothing accelerates it: when does not matter.
    begin = {by_f.y, next->begin.psi > psi ? 0 : -by_f.v / at.motion.a};
    release = *next;
  }
  return std::nullopt;
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
  // A short full sine leaves a velocity that is the difference of its two halves.
  constexpr double short_sine = 1e3;
  if (full && lambda > short_sine) {
    return std::nullopt;
  }
  return under_sine(lambda, f, full ? 2 * pi : pi);
}

}  // namespace stillpoint::design
