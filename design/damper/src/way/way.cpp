// SPDX-License-Identifier: MIT
#include "way/way.hpp"

#include "falling_root.hpp"
#include "region/edges.hpp"
#include "unit_problem.hpp"
#include "wide.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// phi of the strip's tip, where Delta = 0: ((2n + 1) phi - q)^2 - phi^2 = v^2, or, where the rest
/// is at the peak, 2n phi in place of the first term.
double strip_tip(int n, double q, double v) {
  const double m = 2.0 * n + 1;
  const double tip = (m * q + std::sqrt(q * q + (m * m - 1) * v * v)) / (m * m - 1);
  return tip >= q ? tip : v / std::sqrt(4.0 * n * n - 1);
}

/// The same with damping or breakaway: what the strip needs grows with phi, and at v / sqrt(3) it
/// is above v^2.
double general_tip(const Way& way) {
  const double square = way.v_low > 0 ? way.v_low * way.v_low : 1;
  const auto spare = [&](double a) { return square - reach_edge(way, a, 0).square; };
  constexpr double beyond = 1 + 1e-9;  // rounding, with hardly any damping
  const double most = std::sqrt(square / 3) * beyond;
  return falling_root(spare, 0, most, square, spare(most));
}

double tip_of(const Way& way, double f3) {
  if (way.n == 0) {
    return HUGE_VAL;
  }
  const bool general = way.problem.zeta.high > 0 || way.problem.breakaway > 1;
  if (general && (way.n > 1 || way.q > 0)) {
    return way.f_of(general_tip(way));
  }
  return way.n == 1 && way.q == 0
             ? f3
             : way.f_of(strip_tip(way.n, way.q, way.problem.starting_v0() / way.problem.v0));
}

double below_dead_zone(const Problem& problem) {
  return std::nextafter(edges(problem, {}).f1, 0.0);
}

/// f2 of the residual in place of beta: (69).
double least_f_at_peak(Problem problem) {
  problem.beta = residual_of(problem);
  return problem.beta > 0 ? edges(problem, {}).f2 : HUGE_VAL;
}

}  // namespace

double residual_of(const Problem& problem) {
  return std::min(problem.residual.value_or(0), problem.beta);
}

double largest_f_at_rest(const Problem& problem) {
  const double r = residual_of(problem);
  const double below = rounded_down(Wide(r) * problem.p * problem.p / problem.breakaway);
  const bool all = below >= edges(problem, {}).f1 || least_f_at_peak(problem) <= below;
  return r > 0 && all ? below_dead_zone(problem) : below;
}

double stop_radius(const Problem& problem) {
  return problem.criterion == Criterion::published ? 0 : 1;
}

Way::Way(const Problem& what, const Limits& allowed, int arrival, bool by_peak)
    : problem(what),
      limits(allowed),
      n(arrival),
      at_peak(by_peak),
      plain(is_plain(what, allowed)),
      v_low(what.v0_low.value_or(what.v0) / what.v0),
      p_ratio(what.stiffest_p() / what.p),
      q(residual_of(what) * what.p / what.v0) {
  const Edges edge = edges(what, allowed);
  f2 = at_peak ? least_f_at_peak(what) : edge.f2;
  delta_cap = edge.delta_cap;
  f_cap = std::min(edge.f4, edge.f_max);
  if (n == 0) {
    f_cap = std::min(f_cap, at_peak ? below_dead_zone(what) : largest_f_at_rest(what));
  }
  if (what.zeta.high > 0) {  // with more, hardly anything moves: a load case is not searched there
    f_cap = std::min(f_cap, what.p * what.v0);
  }
  tip = tip_of(*this, edge.f3);
  f_top = std::min(f_cap, tip);
  a2 = scaled(f2);
  a_cap = scaled(f_top);
  d_cap = delta_cap / what.v0 / what.v0;
}

Sides sides(const BoxShape& shape, double tolerance) {
  return {1 - tolerance * shape.f_low, 1 + tolerance * shape.f_high,
          1 - tolerance * shape.delta_low, 1 + tolerance * shape.delta_high};
}

unit::EdgeStart reach_start(const Way& way, double a) {
  const double zeta = way.problem.zeta.high;
  const double grown = zeta > 0 ? unit::shrinks_by(zeta) : 1;
  const double near = 2 * a + (a - way.q) * grown;
  const double slides = 1 + way.problem.breakaway;
  return near > slides * a ? unit::EdgeStart{near, 2 + grown, a, 1, zeta}
                           : unit::EdgeStart{slides * a, slides, a, 1, zeta};
}

unit::EdgeStart last_start(const Way& way, double a) {
  const double c = stop_radius(way.problem) / way.p_ratio;
  return {c * a, c, a / way.p_ratio, 1 / way.p_ratio, way.problem.zeta.low};
}

/// Rests within r on the next half-cycle, (55), at the tightest point whose dead zone is at least
/// q, (56).
unit::EdgeStart stop_start(const Way& way, double a) {
  const double c = stop_radius(way.problem);
  const double q = way.q;
  const double held = way.problem.breakaway;
  const double at = std::max(a, q / held);
  const double moves = held * a >= q ? 1 : 0;
  if (const double k = way.p_ratio; held * at >= q * k * k) {
    return {c * at / k + q * k, moves * c / k, at / k, moves / k, way.problem.zeta.low};
  }
  const double phi = std::sqrt(at * q / held);
  return {(c + held) * phi, moves * (c + held) * phi / (2 * at), phi, moves * phi / (2 * at),
          way.problem.zeta.low};
}

unit::EdgeSpeed reach_edge(const Way& way, double a, double d) {
  return followed_back(reach_start(way, a), way.n - 1, d);
}

unit::EdgeSpeed last_edge(const Way& way, double a, double d) {
  return followed_back(last_start(way, a), way.passages(), d);
}

unit::EdgeSpeed stop_edge(const Way& way, double a, double d) {
  return followed_back(stop_start(way, a), way.n, d);
}

unit::EdgeSpeed returning_notch(const Way& way, double a) {
  return followed_back(reach_start(way, a), 0, 0);
}

double least_beta(const Way& way) {
  const double held = way.problem.breakaway;
  // The peak and the dead zone are equally wide there, (70).
  const double narrowest = 1 / std::sqrt((held + 1) * (held + 1) - 1);
  Problem wide = way.problem;
  wide.beta = std::max(wide.beta, wide.v0 / wide.p);
  const double a = way.at_peak ? way.a2 : std::min(Way(wide, {}, way.n).a_cap, narrowest);
  return std::max(unit::peak(a), held * a) * way.problem.v0 / way.problem.p;
}

double largest_f(const Problem& problem) {
  const Way at_peak(problem, {}, 0, true);
  return std::max({Way(problem, {}, 1).f_top, largest_f_at_rest(problem),
                   at_peak.f2 <= at_peak.f_cap ? at_peak.f_cap : 0});
}

std::optional<Way> way_of(const Problem& problem, const Limits& limits, double f, double delta) {
  std::optional<Way> found;
  const auto visit = [&](const Way& way) {
    if (admissible(way, f, delta)) {
      found.emplace(way);
    }
    return !found;
  };
  for_each_way(problem, limits, visit);
  if (f == 0 && !found) {
    visit(Way(problem, limits, 0));  // without constant friction every rest is at x = 0
  }
  return found;
}

Way way_with(const Problem& problem, const Limits& limits, int arrival, double f) {
  return {problem, limits, arrival, arrival == 0 && f > largest_f_at_rest(problem)};
}

}  // namespace stillpoint::design
