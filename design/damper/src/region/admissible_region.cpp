// SPDX-License-Identifier: MIT
#include <stillpoint/design/admissible_region.hpp>

#include "region/edges.hpp"
#include "region/limit_table.hpp"
#include "way/extent.hpp"
#include "wide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

Region region_of(const Problem& problem, const Edges& edge, const Limits& limits) {
  const auto& most = limits.acceleration_max;
  return {.f1 = edge.f1,
          .f2 = edge.f2,
          .f3 = edge.f3,
          .f4 = most ? std::optional(acceleration_edge(problem, *most)) : std::nullopt,
          .delta2 = edge.delta2,
          .f_lower = {},
          .f_upper = {}};
}

void explain(Region& region, Conflict conflict, const LimitKind* limit = nullptr) {
  region.conflict = conflict;
  region.limit = limit;
}

/// Ranges may be too wide for any damper. One hit and one spring never are.
bool stroke_helps(Problem problem, const Limits& limits) {
  if (!problem.v0_low && !problem.p_high) {
    return true;
  }
  problem.beta = std::max(problem.beta, 2 * problem.v0 / problem.p);  // f2 <= 0
  bool found = false;
  for_each_way(problem, {.tolerance = limits.tolerance, .shape = limits.shape},
               [&](const Way& way) {
                 found = feasible_f(way).has_value();
                 return !found;
               });
  return found;
}

/// Why no way has a point, the paper's or any.
void explain(Region& region, const Problem& problem, const Limits& limits, const Edges& edge) {
  const auto given = limit_edges(problem, limits);
  if (needs_a_notch(problem, limits)) {
    const auto no_notch = std::ranges::find(given, 0.0, &LimitEdge::limit);
    return explain(region, Conflict::stop_against_limit, no_notch->kind);
  }
  const auto fits = [&](double cap) {
    return lowest_centre(edge.f2, limits.tolerance * limits.shape.f_low) <=
           highest_centre(cap, limits.tolerance * limits.shape.f_high);
  };
  if (!fits(largest_f(problem))) {
    return explain(region, !stroke_helps(problem, limits) ? Conflict::no_arrival
                           : problem.residual.value_or(0) > 0 && !fits(edge.f1)
                               ? Conflict::amplitude_against_dead_zone
                               : Conflict::amplitude_against_return);
  }
  for (const auto& [kind, limit, most] : given) {
    if (kind->bounds_f() && !(most >= 0 && fits(most))) {
      return explain(region, most < 0 ? Conflict::limit_alone : Conflict::amplitude_against_limit,
                     kind);
    }
  }
  if (problem.arrivals > 1 || !is_plain(problem, limits)) {
    return explain(region, Conflict::no_arrival);
  }
  if (stop_fits(problem, edge, limits)) {
    return;
  }
  explain(region, Conflict::stop_against_start);
  for (const auto& [kind, limit, most] : given) {
    if (!kind->bounds_f() && most == edge.delta_cap) {
      explain(region, Conflict::stop_against_limit, kind);
    }
  }
}

/// V0/(sqrt(2) p), (10), as the least double that leaves an f between the rounded edges.
double least_beta(Problem problem) {
  // f2 and f3 are each rounded inwards by an ulp at most and an ulp of beta moves f2 by three, so
  // the least beta is within an ulp or two of the quotient. A start above it would miss the least
  // one.
  constexpr int ulps_below = 4;
  problem.beta = static_cast<double>(problem.v0 / (root(Wide(2)) * problem.p));
  for (int i = 0; i < ulps_below; ++i) {
    problem.beta = std::nextafter(problem.beta, 0.0);
  }
  for (Edges edge = edges(problem, {}); !box_fits(edge.f2, edge.f3, 0); edge = edges(problem, {})) {
    problem.beta = std::nextafter(problem.beta, HUGE_VAL);
  }
  return problem.beta;
}

}  // namespace

Region admissible_region(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  const bool plain = is_plain(problem, limits);
  const Edges edge = edges(problem, limits);
  Region region = region_of(problem, edge, limits);
  region.beta_min =
      plain ? least_beta(problem)
            : std::min(least_beta(Way(problem, {}, 1)), least_beta(Way(problem, {}, 0)));
  for_each_way(problem, limits, [&](const Way& way) {
    if (const auto ends = feasible_f(way)) {
      region.f_lower = std::min(ends->low, region.f_lower.value_or(HUGE_VAL));
      region.f_upper = std::max(ends->high, region.f_upper.value_or(0));
    }
    return true;
  });
  region.feasible = region.f_lower.has_value();
  if (!region.feasible) {
    explain(region, problem, limits, edge);
  }
  return region;
}

double delta1_published(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  Problem published = problem;
  published.criterion = Criterion::published;
  return unchecked_delta1(published, f);
}

std::optional<double> delta1_exact(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  if (f > edges(problem, {}).f3) {
    return std::nullopt;
  }
  Problem exact = problem;
  exact.criterion = Criterion::exact;
  return unchecked_delta1(exact, f);
}

std::optional<double> delta1(const Problem& problem, double f) {
  return problem.criterion == Criterion::published ? delta1_published(problem, f)
                                                   : delta1_exact(problem, f);
}

}  // namespace stillpoint::design
