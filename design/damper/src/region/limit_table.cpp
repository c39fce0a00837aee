// SPDX-License-Identifier: MIT
#include "region/limit_table.hpp"

#include "falling_root.hpp"
#include "way/unit_strip.hpp"
#include "wide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// Over V0 p: over the damping it first falls and then grows, so one of the ends feels the most.
double felt(const Interval& zeta, double a) {
  return std::max(unit::damped_acceleration(zeta.low, a), unit::damped_acceleration(zeta.high, a));
}

/// Of a limit of the acceleration, with damping.
double damped_edge(const Problem& problem, double limit) {
  const double unit = problem.v0 * problem.stiffest_p();
  const auto spare = [&](double a) { return limit / unit - felt(problem.zeta, a); };
  const double without = spare(0);
  return without > 0 ? falling_root(spare, 0, limit / unit, without, spare(limit / unit)) * unit
                     : without * unit;
}

}  // namespace

double acceleration_edge(const Problem& problem, double limit) {
  if (problem.zeta.high > 0) {
    return damped_edge(problem, limit);
  }
  const Wide most = limit;
  const Wide p_v0 = Wide(problem.v0) * problem.stiffest_p();
  if (is_same(p_v0, most)) {
    return 0;
  }
  const double unit = std::ldexp(1, std::ilogb(std::max(limit, static_cast<double>(p_v0))));
  const Wide square = less_product(limit, problem.v0, problem.stiffest_p()).times(1 / unit) *
                      (most + p_v0).times(1 / unit);
  return rounded_down((square < 0 ? -root(-square) : root(square)).times(unit));
}

double least_acceleration(const Problem& problem) {
  return problem.stiffest_p() * problem.v0 * (problem.zeta.high > 0 ? felt(problem.zeta, 0) : 1);
}

double roomiest_p(const Problem& problem, const Limits& limits, double limit) {
  const double wider = (1 + limits.tolerance) / (1 - limits.tolerance);
  const double f4 = problem.v0 / problem.beta / wider * problem.v0;
  return f4 < limit ? std::sqrt((limit - f4) / problem.v0) * std::sqrt((limit + f4) / problem.v0)
                    : 0;
}

std::span<const LimitKind> limit_kinds() {
  return limit_table;
}

std::vector<LimitEdge> limit_edges(const Problem& problem, const Limits& limits) {
  std::vector<LimitEdge> list;
  for (const LimitKind& kind : limit_table) {
    if (const auto& limit = limits.*kind.value) {
      list.push_back({&kind, *limit, kind.figure ? kind.figure->edge(problem, *limit) : *limit});
    }
  }
  return list;
}

double figures_edge(const Problem& problem, const Limits& limits) {
  double least = HUGE_VAL;
  for (const LimitKind& kind : limit_table) {
    if (const auto& limit = limits.*kind.value; limit && kind.figure) {
      least = std::min(least, kind.figure->edge(problem, *limit));
    }
  }
  return least;
}

double largest_delta_allowed(const Limits& limits) {
  return least_limit(Bounded::delta, limits);
}

double largest_f_allowed(const Problem& problem, const Limits& limits) {
  return std::min(least_limit(Bounded::f, limits), figures_edge(problem, limits));
}

void require_valid(const Problem& problem, const Limits& limits) {
  require_valid(problem);
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  for (const double side : {f_low, f_high, delta_low, delta_high}) {
    require_within("shape", side, 0, 1);
  }
  if (!(std::max({f_low, f_high, delta_low, delta_high}) > 0)) {
    throw InputError("tolerance", 0.0, "must be above 0 on at least one side of f or delta");
  }
  for (const LimitKind& kind : limit_kinds()) {
    if (const auto& limit = limits.*kind.value) {
      require_within(kind.field, *limit, kind.least(), largest_square);
    }
  }
  if (!(limits.tolerance >= 0 && limits.tolerance < 1)) {
    throw InputError("tolerance", limits.tolerance,
                     "must be at least 0 and less than 1 (0.1 is 10 %)");
  }
}

bool is_plain(const Problem& problem, const Limits& limits) {
  return problem.v0_low.value_or(problem.v0) == problem.v0 && problem.stiffest_p() == problem.p &&
         !problem.residual && problem.zeta.high == 0 && limits.shape == BoxShape{};
}

}  // namespace stillpoint::design
