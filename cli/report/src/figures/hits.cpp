// SPDX-License-Identifier: MIT
#include "figures/ends.hpp"
#include "figures/report_figures.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/design/hits.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillpoint::report {

using design::HitEnd;
using figures::AreaLook;
using figures::Figure;
using figures::Ink;

namespace {

/// Whether stronger ones than those that the damper works for stop by the exact criterion.
template <class Task>
bool exact_works_above(Task task, const design::Limits& limits, double f, double delta,
                       const std::optional<design::WorksFor>& works_for) {
  if (!works_for || task.criterion == design::Criterion::exact) {
    return false;
  }
  constexpr double above = 1 + 1e-6;
  task.criterion = design::Criterion::exact;
  const auto exact = design::works_for(task, limits, f, delta);
  return exact && exact->hit.high > above * *works_for->hit.high;
}

/// The hits whose peak is within beta, but whose acceleration outside the notch is not within its
/// limit: sqrt(f^2 + (v0 p)^2) is above it, with the stiffest spring.
std::optional<Interval> above_limit(const design::Problem& problem, const design::Limits& limits,
                                    double f, const std::vector<design::Hits>& hits) {
  if (!limits.acceleration_max) {
    return std::nullopt;
  }
  const double limit = *limits.acceleration_max;
  const double from =
      limit > f ? std::sqrt((limit - f) * (limit + f)) / problem.p_high.value_or(problem.p) : 0;
  const auto far = std::ranges::find(hits, HitEnd::too_far, &design::Hits::end);
  const double to = far == hits.end() ? hits.back().to : far->from;
  return from < to ? std::optional(Interval{from, to}) : std::nullopt;
}

/// Beyond f1 of the softest spring.
std::string held_at_the_limit(const design::Problem& problem, double f, const FigureUnits& units) {
  return f < problem.beta * problem.p * problem.p
             ? ""
             : "friction could hold the mass at " + units.length_words(problem.beta);
}

std::optional<design::ServedInterval> hit_of(const std::optional<design::WorksFor>& works_for) {
  return works_for ? std::optional(works_for->hit) : std::nullopt;
}

}  // namespace

Figure hits_figure(const design::Problem& problem, const design::Limits& limits, double f,
                   double delta, const std::optional<design::WorksFor>& works_for,
                   const FigureUnits& units) {
  const double unit = units.velocity;
  const auto hits = design::shown_hits(problem, f, delta);
  const auto felt = above_limit(problem, limits, f, hits);
  Figure figure =
      ends_figure({.noun = "hit",
                   .measured = "hits",
                   .symbol = "V₀",
                   .scale = unit,
                   .unit = units.velocity_unit,
                   .list = hits,
                   .asked = {problem.v0_low.value_or(problem.v0), problem.v0},
                   .arrivals = static_cast<double>(problem.arrivals),
                   .has_range = problem.v0_low.has_value(),
                   .works = hit_of(works_for),
                   .refusal = held_at_the_limit(problem, f, units),
                   .acceleration_max = felt ? limits.acceleration_max : std::nullopt,
                   .fail_by_criterion = exact_works_above(problem, limits, f, delta, works_for)});
  figure.title = problem.p_high ? "Where the mass stops with the worst spring"
                                : "Where the mass stops after a hit";
  figure.x.label = units.velocity_unit.empty() ? "velocity of the hit, V₀"
                                               : "velocity of the hit V₀, " + units.velocity_unit;
  if (felt) {
    figure.areas.push_back({format("above {:.4g} g", *limits.acceleration_max),
                            figures::rectangle(felt->low * unit, felt->high * unit, 0, 1),
                            Ink::purple, AreaLook::hatched});
  }
  return figure;
}

Figure strengths_figure(const design::PulseProblem& problem, const design::Limits& limits, double f,
                        double delta, const std::optional<design::WorksFor>& works_for) {
  constexpr double room = 1.25;
  const double k = design::peak_load(problem.pulse);
  const auto works = hit_of(works_for);
  Figure figure =
      ends_figure({.noun = "pulse",
                   .measured = "pulses with k",
                   .symbol = "k",
                   .unit = "g",
                   .list = design::shown_strengths(problem, f, delta,
                                                   works ? room * works->high.value_or(0) : 0),
                   .asked = {problem.ranges.k_low.value_or(k), k},
                   .has_range = problem.has_ranges(),
                   .works = works,
                   .acceleration_max = limits.acceleration_max,
                   .fail_by_criterion = exact_works_above(problem, limits, f, delta, works_for)});
  figure.title = problem.p_high || problem.ranges.lambda_high
                     ? "Where the mass stops under the worst of the pulses"
                     : "Where the mass stops under the pulse";
  figure.x.label = "largest acceleration of the pulse k, g";
  return figure;
}

}  // namespace stillpoint::report
