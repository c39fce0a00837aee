// SPDX-License-Identifier: MIT
#include "pulse/first_return.hpp"

#include "pulse/sine_slide.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace stillpoint::design {

namespace {

using std::numbers::pi;

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
  [[nodiscard]] FirstReturn free_inwards(const SlideMotion& now, double time,
                                         const MotionByF& by_f) {
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
  [[nodiscard]] FirstReturn free_outwards(const SlideMotion& now, double time,
                                          const MotionByF& by_f) {
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
      const SlideMotion now{y + (centre - y) * bend, (centre - y) * sine};
      const MotionByF now_by_f{by_f + (sign - by_f) * bend, (sign - by_f) * sine};
      return outwards ? so_far.free_outwards(now, ends, now_by_f)
                      : so_far.free_inwards(now, ends, now_by_f);
    }
    y = 2 * centre - y;
    by_f = 2 * sign - by_f;
    from += pi;
    if (y == 0) {  // f = 0: it comes back without speed
      return so_far.arrival(0, from, 0, 1);
    }
    so_far.turn(y);
    outwards = !outwards;
    if ((outwards ? 1 - y : y - 1) <= f) {  // held until the load ends
      return so_far.free_from(y, ends, by_f);
    }
  }
}

/// The phase of that sine before or after the crest at pi/2.
LoadPhase phase_of(double sine, bool after) {
  const double cosine = std::sqrt((1 - sine) * (1 + sine));
  return after ? LoadPhase{pi - elementary::asin(sine), {sine, -cosine}}
               : LoadPhase{elementary::asin(sine), {sine, cosine}};
}

/// When a mass that has turned starts again.
struct Release {
  LoadPhase begin;
  bool outwards;
};

/// For a mass that has turned at y; empty if it is held for ever. If it has hardly moved, it was on
/// the edge of being held, where rounding would let it start again and again.
std::optional<Release> release_of(double f, double y, double psi, double last, bool moved) {
  const LoadPhase now{psi, elementary::sin_cos(psi)};
  const double load = now.of.sine;
  if (moved && std::abs(y - load) > f) {
    return Release{now, load > y};
  }
  const auto not_before_now = [&](const LoadPhase& then) { return then.psi > psi ? then : now; };
  if (psi < pi / 2 && y + f < 1) {
    return Release{not_before_now(phase_of(y + f, false)), true};
  }
  if (psi >= LoadPhase::second_crest || y - f <= (last > pi ? -1 : 0)) {
    return std::nullopt;
  }
  return Release{not_before_now(phase_of(y - f, true)), false};
}

std::optional<FirstReturn> under_sine(double lambda, double f, double last) {
  MotionSoFar so_far(f);
  double y = 0;
  SlideBeginByF begin;
  Release release{phase_of(f, false), true};
  // For a pulse of a hundred natural periods. Rounding could hold a mass on the edge of a slide.
  constexpr int most_slides = 1000;
  for (int i = 0; i < most_slides; ++i) {
    const bool outwards = release.outwards;
    const double sign = outwards ? -1 : 1;
    const SineSlide slide(lambda, release.begin, sign * f, y);
    const auto [event, at] = slid(slide, outwards, last);
    const MotionByF by_f = slide.by_f(at.h, sign, begin);
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
  if (full ? lambda > short_sine : !std::holds_alternative<HalfSine>(pulse)) {
    return std::nullopt;
  }
  return under_sine(lambda, f, full ? 2 * pi : pi);
}

}  // namespace stillpoint::design
