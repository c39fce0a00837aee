// SPDX-License-Identifier: MIT
#include <stillpoint/design/region.hpp>

#include "nearest_fit.hpp"
#include "region/edges.hpp"
#include "region/limit_table.hpp"
#include "region/mend_list.hpp"
#include "way/extent.hpp"

#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// There is an f between f2 and f3, or f2 and f_max. A larger beta or p, or a smaller v0, only
/// helps.
bool amplitude_fits(const HitCase& now) {
  const Edges edge = edges(now.problem, now.limits);
  return box_fits(edge.f2, std::min(edge.f3, edge.f_max), now.limits.tolerance);
}

/// The same of f4, which falls with p: a larger p may help or harm.
bool figures_fit(const HitCase& now) {
  const Edges edge = edges(now.problem, now.limits);
  return box_fits(edge.f2, edge.f4, now.limits.tolerance);
}

bool strip_fits(const HitCase& now) {
  const Edges edge = edges(now.problem, now.limits);
  return edge.f4 >= 0 && stop_fits(now.problem, edge, now.limits);
}

/// At the first arrival.
bool first_fits(const HitCase& now) {
  return amplitude_fits(now) && figures_fit(now) && strip_fits(now);
}

bool has_damper(const HitCase& now) {
  const bool plain = is_plain(now.problem, now.limits);
  bool fits = plain && first_fits(now);
  if (!fits && !(plain && now.problem.arrivals == 1)) {
    for_each_way(now.problem, now.limits, [&](const Way& way) {
      fits = any_point(way).has_value();
      return !fits;
    });
  }
  return fits;
}

/// No peak is above V0/p. All that an even larger beta admits is a dead zone as wide, and so, with
/// a residual, friction that hardly lets the mass move: not suggested.
Input<HitCase> beta_of(const Problem& problem) {
  const double unmoved =
      std::max({problem.beta, problem.residual.value_or(HUGE_VAL), 2 * problem.v0 / problem.p});
  return {"beta", problem.beta,
          std::min({largest_square, largest_speed / problem.p, problem.v0 / problem.p * far_ratio,
                    unmoved}),
          in_problem(&Problem::beta)};
}

HitCase with_p(HitCase now, double p) {
  now.problem.p = p;
  return now;
}

/// The limit of a figure that leaves the least; empty without one. Its edge falls with p.
std::optional<LimitEdge> limited_figure(const HitCase& now) {
  std::optional<LimitEdge> least;
  for (const LimitEdge& one : limit_edges(now.problem, now.limits)) {
    if (one.kind->figure && (!least || one.edge < least->edge)) {
      least = one;
    }
  }
  return least;
}

/// More p helps the peak and the return and harms the stop.
Input<HitCase> p_of(const Problem& problem) {
  constexpr double far = 1e6;
  const double p = problem.p;
  const auto [least, most] = valid_p(problem);
  return {"p", p, std::min(most, p * far), in_problem(&Problem::p), std::max(least, p / far)};
}

/// The nearest p for the first arrival, to the last bit: more p helps the amplitude and can only
/// harm the stop, so both are tested one after the other.
std::optional<double> mended_p(const HitCase& base) {
  const auto [least, most] = valid_p(base.problem);
  const auto with = [&](const auto& condition) {
    return [&](double p) { return condition(with_p(base, p)); };
  };
  // With a limit of a figure the p that fit are one interval; if it is not empty, the p with the
  // most room is in it, as far as the other conditions let it.
  if (const auto figure = limited_figure(base)) {
    const double roomiest =
        figure->kind->figure->roomiest_p(base.problem, base.limits, figure->limit);
    const auto low = nearest_fit(least, most, with(amplitude_fits));
    const auto high = nearest_fit(most, least, with(strip_fits));
    return low && high && *low <= *high
               ? nearest_fit(base.problem.p, std::clamp(roomiest, *low, *high), with(first_fits))
               : std::nullopt;
  }
  const auto raised = nearest_fit(base.problem.p, most, with(amplitude_fits));
  const auto value = raised ? nearest_fit(*raised, least, with(strip_fits)) : std::nullopt;
  return value && first_fits(with_p(base, *value)) ? value : std::nullopt;
}

}  // namespace

std::vector<Mend> mends(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  const HitCase base{problem, limits};
  std::vector<Mend> list;
  if (has_damper(base)) {
    return list;
  }
  const auto add_if = [&list](const std::optional<Mend>& mend) {
    if (mend) {
      list.push_back(*mend);
    }
  };
  const auto add = [&](const Input<HitCase>& input) { add_if(input.mend(base, has_damper)); };
  // Of a range each end by itself, as far as the other end.
  const double v0 = problem.v0;
  const double p = problem.p;
  const double least_v0 = valid_v0(problem).low;
  if (problem.v0_low.value_or(0) > 0) {
    add({"v0_low", *problem.v0_low, v0, in_problem(&Problem::v0_low)});
  }
  add({problem.v0_low ? "v0_high" : "v0", v0, std::max(problem.v0_low.value_or(0), least_v0),
       in_problem(&Problem::v0)});
  if (problem.p_high) {
    add({"p_low", p, *problem.p_high, in_problem(&Problem::p)});
    add({"p_high", *problem.p_high, p, in_problem(&Problem::p_high)});
  } else if (!is_plain(problem, limits) || problem.arrivals > 1) {
    add(p_of(problem));
  } else if (const auto mended = mended_p(base)) {
    add_if(Mend{"p", *mended, *mended > p});
  }
  add(beta_of(problem));
  if (problem.residual || needs_a_notch(problem, limits)) {
    add({"residual", problem.residual.value_or(0), problem.beta, in_problem(&Problem::residual)});
  }
  std::ranges::for_each(limit_inputs<HitCase>(limits), add);
  HitCase more = base;
  add_if(arrivals_mend(problem, [&](std::int64_t n) {
    more.problem.arrivals = n;
    return has_damper(more);
  }));
  return list;
}

std::optional<double> largest_tolerance_of_any(Problem problem, const Limits& limits) {
  require_valid(problem, limits);
  problem.beta = beta_of(problem).to;
  const double most = most_tolerant_of_all(problem, {.shape = limits.shape}, 0).tolerance;
  return most < limits.tolerance ? std::optional(most) : std::nullopt;
}

std::optional<Criterion> criterion_mend(const Problem& problem, const Limits& limits) {
  const HitCase base{problem, limits};
  return has_damper(base) ? std::nullopt : exact_if_it_fits(base, has_damper);
}

}  // namespace stillpoint::design
