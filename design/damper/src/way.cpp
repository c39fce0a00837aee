// SPDX-License-Identifier: MIT
#include "way.hpp"

#include "unit_problem.hpp"

#include <stillpoint/design/region.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace stillpoint::design {

namespace {

using Wide = long double;
using unit::EdgeSpeed;
using unit::EdgeStart;
using unit::Ends;

/// How far inside of its edges a design stays, as in settle.cpp.
constexpr double way_inset = 1e-9;

double least_double_above(Wide value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

double largest_double_below(Wide value) {
  const auto nearest = static_cast<double>(value);
  return nearest > value ? std::nextafter(nearest, -HUGE_VAL) : nearest;
}

/// A rest beyond beta is none within it, whatever residual is allowed.
double residual_of(const Problem& problem) {
  return std::min(problem.residual.value_or(0), problem.beta);
}

/// f <= r p^2, and below f1, where the dead zone begins to be wider than beta.
double largest_f_at_rest(const Problem& problem) {
  const double r = residual_of(problem);
  const double edge = largest_double_below(Wide(r) * problem.p * problem.p);
  const double f1 = problem.beta * problem.p * problem.p;
  return r > 0 && edge >= f1 ? std::nextafter(f1, 0.0) : edge;
}

double stop_radius(const Problem& problem) {
  return problem.criterion == Criterion::published ? 0 : 1;
}

/// phi of the strip's tip, where Delta = 0: ((2n + 1) phi - q)^2 - phi^2 = v^2, or, where the rest
/// is at the peak, 2n phi in place of the first term.
double strip_tip(int n, double q, double v) {
  const double m = 2.0 * n + 1;
  const double tip = (m * q + std::sqrt(q * q + (m * m - 1) * v * v)) / (m * m - 1);
  return tip >= q ? tip : v / std::sqrt(4.0 * n * n - 1);
}

EdgeStart reach_start(const Way& way, double a) {
  return a >= way.q ? EdgeStart{3 * a - way.q, 3, a} : EdgeStart{2 * a, 2, a};
}

EdgeStart last_start(const Way& way, double a) {
  const double c = stop_radius(way.problem) / way.p_ratio;
  return {c * a, c, a / way.p_ratio, 1 / way.p_ratio};
}

/// Rests within r on the next half-cycle, (55), at the tightest point with phi >= q, (56).
EdgeStart stop_start(const Way& way, double a) {
  const double c = stop_radius(way.problem);
  const double q = way.q;
  const double at = std::max(a, q);
  const double moves = a >= q ? 1 : 0;
  if (const double k = way.p_ratio; at >= q * k * k) {
    return {c * at / k + q * k, moves * c / k, at / k, moves / k};
  }
  const double phi = std::sqrt(at * q);
  return {(c + 1) * phi, moves * (c + 1) * phi / (2 * at), phi, moves * phi / (2 * at)};
}

}  // namespace

Way::Way(const Problem& what, const Limits& allowed, int arrival)
    : problem(what),
      limits(allowed),
      n(arrival),
      v_low(what.v0_low.value_or(what.v0) / what.v0),
      p_ratio(what.stiffest_p() / what.p),
      q(residual_of(what) * what.p / what.v0) {
  const Edges edge = edges(what, allowed);
  f2 = edge.f2;
  delta_cap = edge.delta_cap;
  f_cap = std::min(edge.f4, allowed.f_max.value_or(HUGE_VAL));
  if (n == 0) {
    f_cap = std::min(f_cap, largest_f_at_rest(what));
  }
  a2 = scaled(f2);
  f_top = n == 0 ? f_cap : std::min(f_cap, f_of(strip_tip(n, q, what.starting_v0() / what.v0)));
  a_cap = scaled(f_top);
  d_cap = delta_cap / what.v0 / what.v0;
}

Way Way::with_box(double tolerance) const {
  Way other = *this;
  other.limits.tolerance = tolerance;
  return other;
}

EdgeSpeed reach_edge(const Way& way, double a, double d) {
  return followed_back(reach_start(way, a), way.n - 1, d);
}

EdgeSpeed last_edge(const Way& way, double a, double d) {
  return followed_back(last_start(way, a), way.passages(), d);
}

EdgeSpeed stop_edge(const Way& way, double a, double d) {
  return followed_back(stop_start(way, a), way.n, d);
}

EdgeSpeed returning_notch(const Way& way, double a) {
  return followed_back(reach_start(way, a), 0, 0);
}

namespace {

/// In speeds: phi = f/p, d = 2 Delta.
struct Corner {
  Wide phi;
  Wide d;

  [[nodiscard]] Wide square_before(Wide radius, int steps) const {
    for (int i = 0; i < steps; ++i) {
      radius = 2 * phi + std::sqrt(radius * radius + d);
    }
    return (radius - phi) * (radius + phi);
  }
};

Wide widened_reach(const Way& way, Wide f) {
  const Wide phi = f / way.problem.p;
  return std::max(2 * phi, 3 * phi - Wide(way.problem.p) * residual_of(way.problem));
}

/// The square of V0 that reaches, or twice the Delta that sends every hit back.
Wide reach_square(const Way& way, double f, double delta) {
  const Corner corner{f / Wide(way.problem.p), 2 * Wide(delta)};
  return corner.square_before(widened_reach(way, f), way.v_low > 0 ? way.n - 1 : 0);
}

double pass_speed(const Way& way, double f, double delta) {
  const Problem& problem = way.problem;
  const Wide p = problem.stiffest_p();
  const Wide r = residual_of(problem);
  const Wide c = stop_radius(problem);
  const auto speed = [&](Wide phi, Wide radius, int steps) {
    return least_double_above(std::sqrt(Corner{phi, 2 * Wide(delta)}.square_before(radius, steps)));
  };
  double least = HUGE_VAL;
  if (way.n == way.passages() || way.n == 0 || r > 0) {
    least = speed(f / p, c * f / p, way.passages());
  }
  if (way.stops_early()) {
    const Wide at = r > 0 ? std::max<Wide>(f, r * way.problem.p * way.problem.p) : f;
    const Wide spring = r > 0 ? std::min(p, std::sqrt(at / r)) : p;
    least = std::min(least, speed(at / spring, c * at / spring + r * spring, way.n));
  }
  return least;
}

/// As parts of the centre.
struct Sides {
  double f_low;
  double f_high;
  double delta_low;
  double delta_high;
};

Sides sides(const BoxShape& shape, double tolerance) {
  return {1 - tolerance * shape.f_low, 1 + tolerance * shape.f_high,
          1 - tolerance * shape.delta_low, 1 + tolerance * shape.delta_high};
}

Sides sides(const Way& way) {
  return sides(way.limits.shape, way.limits.tolerance);
}

/// How far a side may go, (edge - value) / value over its part of the tolerance.
double side_room(double room, double value, double part) {
  return room < 0 ? 0 : part * value > 0 ? room / value / part : 1;
}

double tolerance_of_f(const Way& way, double f) {
  const BoxShape& shape = way.limits.shape;
  const double floor = way.f2 > 0 ? side_room(f - way.f2, f, shape.f_low) : 1;
  const double cap = side_room(way.f_top - f, f, shape.f_high);
  return std::clamp(std::min(floor, cap), 0.0, 1.0);
}

/// The d for which V0^2 on an edge is `square`, by Newton's method in y = sqrt(2 d): V0^2 is convex
/// in y, docs/theory.md section 13, so it comes down from the right. 0 where V0^2 is above `square`
/// anyway.
double d_on_edge(const EdgeStart& start, int steps, double square) {
  if (steps == 0 || followed_back(start, steps, 0).square >= square) {
    return 0;
  }
  // Every passage takes 2 d at least.
  double y = std::sqrt(square / steps);
  for (int i = 0; i < 100; ++i) {
    const EdgeSpeed now = followed_back(start, steps, y * y / 2);
    const double slope = now.by_d * y;
    const double next = y - (now.square - square) / slope;
    if (!(next < y) || !(next > 0)) {
      break;
    }
    y = next;
  }
  return y * y / 2;
}

/// The d of the low corner from which on the strongest hit stops, and the d of the high corner up
/// to which the weakest comes back, at the corners in f of the box around `a`.
Ends edges_at(const Way& way, double a, const Sides& box) {
  const double a_low = a * box.f_low;
  const double a_high = a * box.f_high;
  Ends ends{0, way.d_cap};
  if (way.n == 0 || !way.stops_early() || way.q > 0) {
    ends.low = d_on_edge(last_start(way, a_low), way.passages(), 1);
  }
  if (way.stops_early()) {
    ends.low = std::max(ends.low, d_on_edge(stop_start(way, a_low), way.n, 1));
  }
  if (way.n == 0) {
    return ends;
  }
  const EdgeStart reach = reach_start(way, a_high);
  if (way.v_low == 0) {
    ends.low = std::max(ends.low, followed_back(reach, 0, 0).square / 2);
  } else if (way.n > 1) {
    ends.high = std::min(ends.high, d_on_edge(reach, way.n - 1, way.v_low * way.v_low));
  }
  return ends;
}

/// Of the room for Delta: the tolerance of Delta alone that it leaves, negative where there is
/// none. In [-1, 1].
double room(const Way& way, double a, double tolerance) {
  const Sides box = sides(way.limits.shape, tolerance);
  const auto [low, high] = edges_at(way, a, box);
  const double least = low / box.delta_low;
  const double most = high / box.delta_high;
  return least + most > 0 ? (most - least) / (most + least) : 0;
}

/// Where a falling function is 0.
template <class F>
double falling_root(const F& function, double low, double high, double at_low, double at_high) {
  std::uintmax_t most_evaluations = 100;
  return boost::math::tools::toms748_solve(function, low, high, at_low, at_high,
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .first;
}

/// The largest tolerance of any Delta for a; negative where there is none, by how much.
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

/// The f of the centres whose box is within the edges of f alone.
std::optional<Ends> within_f(const Way& way) {
  const auto& [f_low, f_high, delta_low, delta_high] = way.limits.shape;
  const double t = way.limits.tolerance;
  if (!(way.f_top > 0)) {
    return std::nullopt;
  }
  // On the tip itself the weakest hit only grazes x = 0.
  const double grazing = way.n > 0 && way.f_top < way.f_cap ? 1 - way_inset : 1;
  const double high = highest_centre(way.f_top * grazing, t * f_high);
  const double least = std::min(high / 2, way_inset * way.problem.v0 * way.problem.p);
  const double low = std::max(lowest_centre(way.f2, t * f_low), least);
  return low <= high ? std::optional(Ends{low, high}) : std::nullopt;
}

struct Highest {
  double at;
  double value;
};

/// The largest value of a function of log f that first rises and then falls, or the first that is
/// `enough`.
template <class F>
Highest highest(const F& function, Ends f, double enough) {
  constexpr int across = 8;    // evenly over f
  constexpr int decades = 16;  // evenly over log f
  const double from = std::log(f.low);
  const double to = std::log(f.high);
  Highest best{to, -HUGE_VAL};
  const auto f_at = [&](double at) { return std::clamp(std::exp(at), f.low, f.high); };
  const auto value_at = [&](double at) { return function(f_at(at)); };
  const auto consider = [&](double at) {
    const double value = value_at(at);
    if (value > best.value) {
      best = {at, value};
    }
    return best.value >= enough;
  };
  std::array<double, across + decades + 1> tried{};
  for (int i = 0; i <= decades; ++i) {
    tried[static_cast<std::size_t>(i)] = from + (to - from) * i / decades;
  }
  for (int i = 1; i <= across; ++i) {
    const double part = (i - 0.5) / across;
    tried[static_cast<std::size_t>(decades + i)] = std::log(f.low + (f.high - f.low) * part);
  }
  // From above: there are the designs that have some constant friction.
  std::ranges::sort(tried, std::greater());
  for (const double at : tried) {
    if (consider(at)) {
      return {f_at(best.at), best.value};
    }
  }
  double left = from;
  double right = to;
  for (const double at : tried) {
    if (at > best.at) {
      right = at;
    } else if (at < best.at) {
      left = at;
      break;
    }
  }
  constexpr double golden = 0.6180339887498949;
  constexpr double resolved = 1e-9;
  double inner_left = right - golden * (right - left);
  double inner_right = left + golden * (right - left);
  double at_left = value_at(inner_left);
  double at_right = value_at(inner_right);
  while (right - left > resolved) {
    if (std::max(at_left, at_right) > best.value) {
      best = at_left > at_right ? Highest{inner_left, at_left} : Highest{inner_right, at_right};
      if (best.value >= enough) {
        break;
      }
    }
    if (at_left >= at_right) {
      right = inner_right;
      inner_right = inner_left;
      at_right = at_left;
      inner_left = right - golden * (right - left);
      at_left = value_at(inner_left);
    } else {
      left = inner_left;
      inner_left = inner_right;
      at_left = at_right;
      inner_right = left + golden * (right - left);
      at_right = value_at(inner_right);
    }
  }
  return {f_at(best.at), best.value};
}

std::optional<Highest> roomiest_f(const Way& way, const Ends& f, double enough) {
  const double t = way.limits.tolerance;
  return highest([&](double at) { return room(way, way.scaled(at), t); }, f, enough);
}

}  // namespace

bool admissible(const Way& way, double f, double delta) {
  const Problem& problem = way.problem;
  const auto [f_low, f_high, delta_low, delta_high] = sides(way);
  if (!(f * f_low >= way.f2 && f * f_high <= way.f_cap && delta * delta_high <= way.delta_cap)) {
    return false;
  }
  if (way.n > 0) {
    const Wide reach =
        reach_square(way, f * f_high, delta * (way.v_low > 0 ? delta_high : delta_low));
    if (!(way.v_low > 0
              ? problem.v0_low.value_or(problem.v0) >= least_double_above(std::sqrt(reach))
              : 2 * Wide(delta * delta_low) >= reach)) {
      return false;
    }
  }
  return problem.v0 < pass_speed(way, f * f_low, delta * delta_low);
}

WaySpeeds way_speeds(const Way& way, double f, double delta) {
  const Wide reach = way.n > 0 ? reach_square(way, f, delta) : 0;
  return {way.v_low > 0 ? least_double_above(std::sqrt(reach)) : least_double_above(reach / 2),
          pass_speed(way, f, delta)};
}

std::optional<double> largest_tolerance(const Way& way, double f, double delta) {
  const auto fits = [&](double tolerance) { return admissible(way.with_box(tolerance), f, delta); };
  if (!fits(0)) {
    return std::nullopt;
  }
  const double a = way.scaled(f);
  const double d = delta / way.square();
  const BoxShape& shape = way.limits.shape;
  // Each is positive inside and falls with the tolerance.
  const auto reaches = [&](double t) {
    const Sides box = sides(shape, t);
    return way.n == 0 ? 1
           : way.v_low > 0
               ? way.v_low * way.v_low - reach_edge(way, a * box.f_high, d * box.delta_high).square
               : 2 * d * box.delta_low - returning_notch(way, a * box.f_high).square;
  };
  const auto stops = [&](double t) {
    const Sides box = sides(shape, t);
    const double low = a * box.f_low;
    const double last = last_edge(way, low, d * box.delta_low).square - 1;
    return way.stops_early()
               ? std::min(way.q > 0 ? last : 1.0, stop_edge(way, low, d * box.delta_low).square - 1)
               : last;
  };
  const auto up_to = [&](const auto& function, double most) {
    const double at_most = function(most);
    const double at_zero = function(0);
    return at_most >= 0   ? most
           : at_zero <= 0 ? 0
                          : falling_root(function, 0, most, at_zero, at_most);
  };
  double tolerance = std::min({tolerance_of_f(way, f), std::nextafter(1.0, 0.0),
                               side_room(way.delta_cap - delta, delta, shape.delta_high)});
  tolerance = up_to(reaches, tolerance);
  tolerance = up_to(stops, tolerance);
  // The root is off by a few roundings for each arrival; steps that double bring the box in.
  for (double step = std::numeric_limits<double>::epsilon(); tolerance > 0 && !fits(tolerance);
       step *= 2) {
    tolerance = std::max(0.0, tolerance - step);
  }
  const double asked = way.limits.tolerance;
  return tolerance < asked && fits(asked) ? asked : tolerance;
}

std::optional<Ends> centre_range(const Way& way, double f) {
  const Sides box = sides(way);
  if (!(f * box.f_low >= way.f2 && f * box.f_high <= way.f_top)) {
    return std::nullopt;
  }
  const auto [low, high] = edges_at(way, way.scaled(f), box);
  const Ends ends{low / box.delta_low, high / box.delta_high};
  return ends.low <= ends.high ? std::optional(ends) : std::nullopt;
}

std::optional<WayPoint> any_point(const Way& way) {
  const auto f = within_f(way);
  if (!f) {
    return std::nullopt;
  }
  // More than rounding, if there is more.
  constexpr double enough = 1e-6;
  const auto best = roomiest_f(way, *f, enough);
  const auto range = centre_range(way, best->at);
  if (!range) {
    return std::nullopt;
  }
  const double delta = (range->low + (range->high - range->low) / 2) * way.square();
  return admissible(way, best->at, delta) ? std::optional(WayPoint{best->at, delta}) : std::nullopt;
}

std::optional<Ends> feasible_f(const Way& way) {
  const auto all = within_f(way);
  const auto inside = any_point(way);
  if (!all || !inside) {
    return std::nullopt;
  }
  const double t = way.limits.tolerance;
  const auto left = [&](double log_f) { return room(way, way.scaled(std::exp(log_f)), t); };
  const auto end = [&](double from) {
    const double at_from = left(std::log(from));
    const double at_inside = left(std::log(inside->f));
    if (at_from >= 0 || at_inside <= 0) {
      return at_from >= 0 ? from : inside->f;
    }
    const double at =
        std::exp(from < inside->f
                     ? falling_root([&](double u) { return -left(u); }, std::log(from),
                                    std::log(inside->f), -at_from, -at_inside)
                     : falling_root(left, std::log(inside->f), std::log(from), at_inside, at_from));
    return std::clamp(at, all->low, all->high);
  };
  Ends ends{end(all->low), end(all->high)};
  if (ends.low == all->low && way.f2 <= 0) {
    ends.low = 0;
  }
  return ends;
}

DesignPoint with_best_delta(const Way& way, double f, BestDelta choice) {
  double t = choice == BestDelta::middle ? std::max(0.0, tolerance_at(way, way.scaled(f)))
                                         : way.limits.tolerance;
  auto range = centre_range(way.with_box(t), f);
  // As in largest_tolerance.
  for (double step = std::numeric_limits<double>::epsilon(); !range && t > 0; step *= 2) {
    t = std::max(0.0, t - step);
    range = centre_range(way.with_box(t), f);
  }
  const auto [low, high] = range.value_or(Ends{0, 0});
  double d = low + (high - low) / 2;
  if (choice == BestDelta::least) {
    d = std::min(low * (1 + way_inset), high);
  } else if (choice == BestDelta::largest) {
    d = std::max(high * (1 - way_inset), low);
  }
  const double delta = d * way.square();
  return {f, delta, largest_tolerance(way, f, delta).value_or(0)};
}

double largest_tolerance(const Way& way) {
  const auto f = within_f(way.with_box(0));
  if (!f) {
    return 0;
  }
  const Highest best =
      highest([&](double at) { return tolerance_at(way, way.scaled(at)); }, *f, HUGE_VAL);
  return best.value > 0 ? with_best_delta(way, best.at).tolerance : 0;
}

double least_beta(const Way& way) {
  const Way free(way.problem, {}, way.n);
  return unit::peak(free.a_cap) * way.problem.v0 / way.problem.p;
}

double largest_f(const Problem& problem) {
  const Way first(problem, {}, 1);
  return std::max(first.f_of(first.a_cap), largest_f_at_rest(problem));
}

std::optional<int> way_of(const Problem& problem, const Limits& limits, double f, double delta) {
  std::optional<int> found;
  const auto visit = [&](const Way& way) {
    if (admissible(way, f, delta)) {
      found = way.n;
    }
    return !found;
  };
  for_each_way(problem, limits, visit);
  if (f == 0 && !found) {
    visit(Way(problem, limits, 0));  // without constant friction every rest is at x = 0
  }
  return found;
}

}  // namespace stillpoint::design
