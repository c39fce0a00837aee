// SPDX-License-Identifier: MIT
#include "pulse/verdict.hpp"
#include "region/edges.hpp"
#include "unit_problem.hpp"
#include "way/extent.hpp"
#include "wide.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

namespace {

Conflict conflict_of(const Problem& problem, const Edges& edges, const Limits& limits) {
  if (!amplitude_fits_return(edges, limits)) {
    return Conflict::amplitude_against_return;
  }
  if (!amplitude_fits_f_max(edges, limits)) {
    return Conflict::amplitude_against_f_max;
  }
  if (edges.f4 < 0) {
    return Conflict::acceleration_alone;
  }
  if (!amplitude_fits_acceleration(edges, limits)) {
    return Conflict::amplitude_against_acceleration;
  }
  if (problem.arrivals > 1) {
    return Conflict::no_arrival;
  }
  if (!stop_fits(problem, edges, limits)) {
    return limits.delta_max && *limits.delta_max == edges.delta_cap
               ? Conflict::stop_against_delta_max
               : Conflict::stop_against_start;
  }
  return Conflict::none;
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
  while (!amplitude_fits_return(edges(problem, {}), {})) {
    problem.beta = std::nextafter(problem.beta, HUGE_VAL);
  }
  return problem.beta;
}

/// What no damper does.
std::string no_way(const Problem& problem, const std::string& box) {
  const bool ranges = problem.v0_low || problem.p_high;
  return fmt::format(
      "no damper {} within {} half-cycle{}{}{}",
      problem.residual ? "brings the mass to rest within the residual" : "stops the mass at x = 0",
      problem.arrivals, problem.arrivals > 1 ? "s" : "",
      ranges ? ", for every hit and spring of the ranges" : "", box);
}

/// Two numbers with six digits, or with all if six do not distinguish them.
std::pair<std::string, std::string> told_apart(double a, double b) {
  std::pair six{fmt::format("{:.6g}", a), fmt::format("{:.6g}", b)};
  return six.first != six.second ? six : std::pair{fmt::format("{}", a), fmt::format("{}", b)};
}

/// Why no way has a point.
Conflict conflict_of_ways(const Problem& problem, const Limits& limits, const Edges& edge) {
  const auto& [f_low, f_high, delta_low, delta_high] = limits.shape;
  const auto fits = [&, f_low = f_low, f_high = f_high](double cap) {
    return lowest_centre(edge.f2, limits.tolerance * f_low) <=
           highest_centre(cap, limits.tolerance * f_high);
  };
  if (!fits(largest_f(problem))) {
    return Conflict::amplitude_against_return;
  }
  if (limits.f_max && !fits(*limits.f_max)) {
    return Conflict::amplitude_against_f_max;
  }
  if (edge.f4 < 0) {
    return Conflict::acceleration_alone;
  }
  return !std::isinf(edge.f4) && !fits(edge.f4) ? Conflict::amplitude_against_acceleration
                                                : Conflict::no_arrival;
}

}  // namespace

Region region_edges(const Problem& problem, const Limits& limits) {
  const Edges edge = edges(problem, limits);
  Region region;
  region.f1 = problem.beta * problem.p * problem.p;
  region.f2 = edge.f2;
  region.f3 = edge.f3;
  if (limits.acceleration_max) {
    region.f4 = edge.f4;
  }
  const double v0 = problem.starting_v0();
  region.delta2 = v0 * v0 / 2;
  return region;
}

Region admissible_region(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  const bool plain = is_plain(problem, limits);
  Region region = region_edges(problem, limits);
  region.beta_min =
      plain ? least_beta(problem)
            : unit::peak(largest_f(problem) / problem.p / problem.v0) * problem.v0 / problem.p;
  for_each_way(problem, limits, [&](const Way& way) {
    if (const auto ends = feasible_f(way)) {
      region.f_lower = std::min(ends->low, region.f_lower.value_or(HUGE_VAL));
      region.f_upper = std::max(ends->high, region.f_upper.value_or(0));
    }
    return true;
  });
  region.feasible = region.f_lower.has_value();
  if (!region.feasible) {
    const Edges edge = edges(problem, limits);
    region.conflict =
        plain ? conflict_of(problem, edge, limits) : conflict_of_ways(problem, limits, edge);
  }
  return region;
}

std::string reason(const Region& region, const Problem& problem, const Limits& limits) {
  const std::string box =
      limits.tolerance > 0 ? fmt::format(", with a tolerance of {:g}", limits.tolerance) : "";
  switch (region.conflict) {
    case Conflict::none:
      return {};
    case Conflict::amplitude_against_return: {
      const bool residual = problem.residual.has_value();
      const auto [least, most] = told_apart(region.f2, residual ? largest_f(problem) : region.f3);
      return fmt::format(
          "amplitude and return exclude each other: a peak within beta needs f >= f2 = {}, coming "
          "{} needs f <= {}{}{}",
          least, residual ? "to rest within the residual" : "back to x = 0",
          residual ? "" : "f3 = ", most, box);
    }
    case Conflict::amplitude_against_f_max: {
      const auto [least, most] = told_apart(region.f2, *limits.f_max);
      return fmt::format(
          "amplitude and f_max exclude each other: a peak within beta needs f >= f2 = {}, f_max is "
          "{}{}",
          least, most, box);
    }
    case Conflict::amplitude_against_acceleration: {
      const auto [least, most] = told_apart(region.f2, *region.f4);
      return fmt::format(
          "amplitude and acceleration exclude each other: a peak within beta needs f >= f2 = {}, a "
          "transmitted acceleration within {:.6g} g needs f <= f4 = {}{}",
          least, *limits.acceleration_max, most, box);
    }
    case Conflict::acceleration_alone: {
      const auto [least, most] = told_apart(problem.p * problem.v0, *limits.acceleration_max);
      return fmt::format(
          "even without friction the transmitted acceleration is p V0 = {} g, above the limit of "
          "{} g",
          least, most);
    }
    case Conflict::narrower_than_rounding:
      return "what the constraints leave lies between neighbouring doubles: no damper is that "
             "exact";
    case Conflict::no_arrival: {
      if (!is_plain(problem, limits)) {
        return no_way(problem, box);
      }
      const Edges edge = edges(problem, limits);
      const double f = highest_centre(edge.f_cap, limits.tolerance) * (1 - limits.tolerance);
      const double delta =
          highest_centre(edge.delta_cap, limits.tolerance) * (1 - limits.tolerance);
      const auto last = static_cast<int>(problem.arrivals);
      const double pass = way_speeds(Way(problem, {}, last), f, delta).pass;
      const auto [least, most] = told_apart(problem.v0, pass);
      return problem.v0 >= pass
                 ? fmt::format(
                       "even with the largest friction allowed the mass passes x = 0 {} times: "
                       "v0 = {}, it would have to be below {}{}",
                       last, least, most, box)
                 : fmt::format(
                       "no damper stops the mass at any of its first {} arrivals within the "
                       "limits{}",
                       last, box);
    }
    case Conflict::stop_against_start:
    case Conflict::stop_against_delta_max:
      break;
  }
  const Edges edge = edges(problem, limits);
  const double f = highest_centre(edge.f_cap, limits.tolerance);
  const auto [least, most] =
      told_apart(delta1(problem, f * (1 - limits.tolerance)).value_or(0), edge.delta_cap);
  const bool by_limit = region.conflict == Conflict::stop_against_delta_max;
  return fmt::format(
      "stop and {} exclude each other: even at the largest f, {:.6g}, stopping needs delta > {}, "
      "{} "
      "{}{}",
      by_limit ? "delta_max" : "start", f, least,
      by_limit ? "delta_max is" : "starting needs delta <= delta2 =", most, box);
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

RegionAnswer answer(const RegionRequest& request) {
  const auto& [problem, limits, f, delta, pulse, ranges] = request;
  if (delta && !f) {
    throw InputError::missing("f", "delta alone is not a point of the region, give f as well");
  }
  if (pulse) {
    return answer_under_pulse(request);
  }
  const Region region = admissible_region(problem, limits);
  RegionAnswer answer{{region, reason(region, problem, limits), mends(problem, limits),
                       joint_mend(problem, limits)}};
  if (!region.feasible) {
    answer.most_tolerant = most_tolerant(problem, limits);
  }
  answer.strips = strips(problem, limits);
  if (f) {
    answer.delta1_published = delta1_published(problem, *f);
    answer.delta1_exact = delta1_exact(problem, *f);
  }
  if (f && delta) {
    answer.constraints = constraints(problem, limits, *f, *delta);
    Limits even = limits;
    even.shape = {};
    answer.tolerance = largest_tolerance(problem, even, *f, *delta);
    answer.admissible = admissible(problem, limits, *f, *delta);
    answer.arrival = *answer.admissible ? arrival_of(problem, *f, *delta) : std::nullopt;
    answer.works_for = works_for(problem, limits, *f, *delta);
    if (answer.works_for) {
      const Oscillator oscillator{problem.p, *f, *delta};
      answer.practice =
          practice(oscillator, free_response(oscillator, {0, problem.v0}), limits.acceleration_max);
    }
  }
  return answer;
}

std::string summary(const RegionVerdict& verdict) {
  const Region& region = verdict.region;
  return region.feasible ? fmt::format("admissible for f from {:.6g} to {:.6g}", *region.f_lower,
                                       *region.f_upper)
                         : "no damper: " + verdict.reason;
}

}  // namespace stillpoint::design
