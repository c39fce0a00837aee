// SPDX-License-Identifier: MIT
#include "way/room.hpp"

#include "falling_root.hpp"
#include "region/edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stillpoint::design {

namespace {

using unit::EdgeStart;
/// How far a side may go, (edge - value) / value over its part of the tolerance.
double side_room(double room, double value, double part) {
  return room < 0 ? 0 : part * value > 0 ? room / value / part : 1;
}

/// With damping the mass loses more than 2 d to each passage.
double damped_d_on_edge(const EdgeStart& start, int steps, double square) {
  constexpr double beyond = 1 + 1e-9;  // rounding, where hardly anything else is lost
  const auto spare = [&](double y) {
    return square - followed_back(start, steps, y * y / 2).square;
  };
  const double without = spare(0);
  if (steps == 0 || without <= 0) {
    return 0;
  }
  const double most = std::sqrt(square / steps) * beyond;
  const double y = falling_root(spare, 0, most, without, spare(most));
  return y * y / 2;
}

/// The d for which V0^2 on an edge is `square`; 0 where V0^2 is above it anyway. One step can be
/// inverted; more need Newton's method in y = sqrt(2 d): V0^2 is convex in y, docs/theory.md
/// section 13, so it comes down from the right.
double d_on_edge(const EdgeStart& start, int steps, double square) {
  if (start.zeta > 0) {
    return damped_d_on_edge(start, steps, square);
  }
  if (steps == 1) {
    const double arrival = std::sqrt(square + start.phi * start.phi) - 2 * start.phi;
    return arrival > start.radius ? (arrival - start.radius) * (arrival + start.radius) / 2 : 0;
  }
  const double without = start.radius + 2 * steps * start.phi;
  if (steps == 0 || (without - start.phi) * (without + start.phi) >= square) {
    return 0;
  }
  // Every passage takes at least 2 d. Each step doubles the correct digits, so a short one is the
  // last.
  constexpr double short_step = 1e-9;
  double y = std::sqrt(square / steps);
  for (double step = y; y > 0 && step > short_step * y;) {
    double r = start.radius;
    double by_y = 0;
    for (int i = 0; i < steps; ++i) {
      const double arrival = std::sqrt(r * r + y * y);
      by_y = (r * by_y + y) / arrival;
      r = 2 * start.phi + arrival;
    }
    step = ((r - start.phi) * (r + start.phi) - square) / (2 * r * by_y);
    y = std::max(0.0, y - step);
  }
  return y * y / 2;
}

}  // namespace

double d_that_stops_at(int n, double a) {
  return d_on_edge({a, 1, a}, n, 1);
}

double d_of_last_stop(const Way& way, double a) {
  return d_on_edge(last_start(way, a), way.passages(), 1);
}

namespace {

/// The least d with which the strongest hit stops, at the low corner.
double d_that_stops(const Way& way, double a) {
  const double last = way.stops_last() ? d_of_last_stop(way, a) : 0;
  return way.stops_early() ? std::max(last, d_on_edge(stop_start(way, a), way.n, 1)) : last;
}

/// The largest d with which the weakest hit comes back, at the high corner.
double d_that_returns(const Way& way, double a) {
  return way.delta_hinders_return()
             ? std::min(way.d_cap, d_on_edge(reach_start(way, a), way.n - 1, way.v_low * way.v_low))
             : way.d_cap;
}

/// The least d at the low corner with which every hit that moves comes back; `a` at the high one.
double d_that_moves(const Way& way, double a) {
  return way.n > 0 && way.v_low == 0 ? returning_notch(way, a).square / 2 : 0;
}

/// At the low corner the least d, at the high one the largest.
Interval edges_between(const Way& way, double a_low, double a_high) {
  return {std::max(d_that_stops(way, a_low), d_that_moves(way, a_high)),
          d_that_returns(way, a_high)};
}

Interval edges_at(const Way& way, double a, const Sides& box) {
  return edges_between(way, a * box.f_low, a * box.f_high);
}

/// By how much V0^2 may grow before the strongest hit passes, at the low corner.
double spare_of_stop(const Way& way, double a, double d) {
  const double last = way.stops_last() ? last_edge(way, a, d).square - 1 : HUGE_VAL;
  return way.stops_early() ? std::min(last, stop_edge(way, a, d).square - 1) : last;
}

/// With the low corner of f at one value and the high one at another.
double room_between(const Way& way, double a_low, double a_high, const Sides& box) {
  if (way.d_cap == 0) {  // then Delta is 0, and has no room: f alone stops the mass or does not
    return d_that_moves(way, a_high) > 0 ? -1 : std::clamp(spare_of_stop(way, a_low, 0), -1.0, 1.0);
  }
  const Interval edge = edges_between(way, a_low, a_high);
  const double least = edge.low / box.delta_low;
  const double most = edge.high / box.delta_high;
  return least + most > 0 ? (most - least) / (most + least) : 0;
}

}  // namespace

std::optional<Interval> centre_range(const Way& way, double f, double tolerance) {
  const Sides box = sides(way.limits.shape, tolerance);
  if (!(f * box.f_low >= way.f2 && f * box.f_high <= way.f_top)) {
    return std::nullopt;
  }
  const auto [low, high] = edges_at(way, way.scaled(f), box);
  const Interval ends{low / box.delta_low, high / box.delta_high};
  return ends.low <= ends.high ? std::optional(ends) : std::nullopt;
}

double room(const Way& way, double a, double tolerance) {
  const Sides box = sides(way.limits.shape, tolerance);
  return room_between(way, a * box.f_low, a * box.f_high, box);
}

bool no_room_between(const Way& way, double a_low, double a_high, double tolerance) {
  const Sides box = sides(way.limits.shape, tolerance);
  return room_between(way, a_high * box.f_low, a_low * box.f_high, box) < 0;
}

double tolerance_of_f(const Way& way, double f) {
  const BoxShape& shape = way.limits.shape;
  const double floor = way.f2 > 0 ? side_room(f - way.f2, f, shape.f_low) : 1;
  const double cap = side_room(way.f_top - f, f, shape.f_high);
  return std::clamp(std::min(floor, cap), 0.0, 1.0);
}

double tolerance_at(const Way& way, double a) {
  const double most = std::min(tolerance_of_f(way, way.f_of(a)), 1 - way_inset);
  const double at_most = room(way, a, most);
  if (at_most >= 0) {
    return most;
  }
  const double at_zero = room(way, a, 0);
  return at_zero <= 0
             ? at_zero
             : falling_root([&](double t) { return room(way, a, t); }, 0, most, at_zero, at_most);
}

std::optional<double> largest_tolerance(const Way& way, double f, double delta) {
  const auto fits = [&](double tolerance) { return admissible(way, f, delta, tolerance); };
  if (!fits(0)) {
    return std::nullopt;
  }
  const double a = way.scaled(f);
  const double d = delta / way.square();
  const BoxShape& shape = way.limits.shape;
  // Each is positive inside and falls with the tolerance.
  const auto reaches = [&](double t) {
    const Sides box = sides(shape, t);
    return way.v_low > 0
               ? way.v_low * way.v_low - reach_edge(way, a * box.f_high, d * box.delta_high).square
               : 2 * d * box.delta_low - returning_notch(way, a * box.f_high).square;
  };
  const auto stops = [&](double t) {
    const Sides box = sides(shape, t);
    return spare_of_stop(way, a * box.f_low, d * box.delta_low);
  };
  const auto up_to = [&](const auto& function, double most) {
    const double at_most = function(most);
    if (at_most >= 0) {
      return most;
    }
    const double at_zero = function(0);
    return at_zero <= 0 ? 0 : falling_root(function, 0, most, at_zero, at_most);
  };
  double tolerance = std::min({tolerance_of_f(way, f), std::nextafter(1.0, 0.0),
                               side_room(way.delta_cap - delta, delta, shape.delta_high)});
  if (way.delta_hinders_return() || (way.n > 0 && way.v_low == 0)) {
    tolerance = up_to(reaches, tolerance);
  }
  tolerance = up_to(stops, tolerance);
  // The root is off by a few roundings for each arrival; doubling steps bring the box inside.
  for (double step = std::numeric_limits<double>::epsilon(); tolerance > 0 && !fits(tolerance);
       step *= 2) {
    tolerance = std::max(0.0, tolerance - step);
  }
  const double asked = way.limits.tolerance;
  return tolerance < asked && fits(asked) ? asked : tolerance;
}

double best_delta(const Way& way, double f, BestDelta choice) {
  const bool most_tolerant = choice == BestDelta::most_tolerant;
  const double asked = way.limits.tolerance;
  double t = most_tolerant ? std::max(0.0, tolerance_at(way, way.scaled(f))) : asked;
  const auto settled = [&](double d) {
    return std::min(d * way.square(),
                    highest_centre(way.delta_cap, asked * way.limits.shape.delta_high));
  };
  if (most_tolerant && way.is_papers_task()) {  // (30)
    const auto [low, high] = edges_at(way, way.scaled(f), sides(way.limits.shape, t));
    return settled(low + (high - low) / 2);
  }
  auto range = centre_range(way, f, t);
  // A requested box that fails to fit by more than rounding has no Delta.
  const bool may_fit = range || most_tolerant || centre_range(way, f, std::max(0.0, t - way_inset));
  // As in largest_tolerance.
  for (double step = std::numeric_limits<double>::epsilon(); may_fit && !range && t > 0;
       step *= 2) {
    t = std::max(0.0, t - step);
    range = centre_range(way, f, t);
  }
  const auto [low, high] = range.value_or(Interval{0, 0});
  return settled(choice == BestDelta::least     ? std::min(low * (1 + way_inset), high)
                 : choice == BestDelta::largest ? std::max(high * (1 - way_inset), low)
                                                : low + (high - low) / 2);
}

DesignPoint with_best_delta(const Way& way, double f) {
  const double delta = best_delta(way, f, BestDelta::most_tolerant);
  return {f, delta, largest_tolerance(way, f, delta).value_or(0)};
}

}  // namespace stillpoint::design
