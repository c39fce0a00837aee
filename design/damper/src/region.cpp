// SPDX-License-Identifier: MIT
#include "region_edges.hpp"
#include "strip.hpp"
#include "unit_problem.hpp"
#include "way.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stillpoint::design {

namespace {

/// The bounds of Delta in long double, rounded once, so that their strict edge is right to the last
/// bit. Speeds, as in core: phi = f/p, radius = S/p.
class WideArc {
 public:
  WideArc(const Problem& problem, double f)
      : v0_(problem.v0),
        phi_(f / static_cast<long double>(problem.stiffest_p())),
        radius_(std::sqrt(v0_ * v0_ + phi_ * phi_)) {}

  [[nodiscard]] double published() const {
    const long double speed = radius_ - 2 * phi_;
    return half_of(speed * speed);
  }
  [[nodiscard]] double exact() const {
    const long double returns = (v0_ * v0_ - 8 * phi_ * phi_) / (radius_ + 3 * phi_);
    return half_of((radius_ - phi_) * std::max(0.0L, returns));
  }

 private:
  /// At f = 0 it is Delta2 itself, which is rounded as a product of doubles.
  [[nodiscard]] double half_of(long double square) const {
    const auto v0 = static_cast<double>(v0_);
    return phi_ == 0 ? v0 * v0 / 2 : static_cast<double>(square / 2);
  }

  long double v0_;
  long double phi_;
  long double radius_;
};

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
  problem.beta = static_cast<double>(problem.v0 / (std::numbers::sqrt2_v<long double> * problem.p));
  for (int i = 0; i < ulps_below; ++i) {
    problem.beta = std::nextafter(problem.beta, 0.0);
  }
  while (!amplitude_fits_return(edges(problem, {}), {})) {
    problem.beta = std::nextafter(problem.beta, HUGE_VAL);
  }
  return problem.beta;
}

/// The infimum of f for which Delta1 of the box's low corner leaves room below the cap.
double lower_end_from_stop(const Problem& problem, const Edges& edges, double tolerance) {
  // Delta2 is v0^2/2: dividing the rounded square by v0 twice may miss 1/2, and f = 0 with it.
  const double delta2 = problem.v0 * problem.v0 / 2;
  const double highest =
      edges.delta_cap == delta2 ? 0.5 : edges.delta_cap / problem.v0 / problem.v0;
  const double d = highest * (1 - tolerance) / (1 + tolerance);
  const double a = unit::delta1_inverse(problem.criterion, d);
  return a * problem.v0 * problem.p / (1 - tolerance);
}

/// The region of all arrivals that are allowed from that of the first.
void add_later_strips(Region& region, const Problem& problem, const Limits& limits) {
  for_each_strip(problem, limits, [&](const StripTask& task) {
    if (any_point(task)) {
      const auto ends = feasible_f(task).value();
      region.f_lower = std::min(ends.low, region.f_lower.value_or(HUGE_VAL));
      region.f_upper = std::max(ends.high, region.f_upper.value_or(0));
    }
    return true;
  });
  region.feasible = region.f_lower.has_value();
  if (region.feasible) {
    region.conflict = Conflict::none;
  } else if (region.conflict == Conflict::stop_against_start ||
             region.conflict == Conflict::stop_against_delta_max) {
    region.conflict = Conflict::no_arrival;
  }
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

Region region_of_ways(const Problem& problem, const Limits& limits) {
  const Edges edge = edges(problem, limits);
  Region region = region_edges(problem, limits);
  region.beta_min =
      unit::peak(largest_f(problem) / problem.p / problem.v0) * problem.v0 / problem.p;
  for_each_way(problem, limits, [&](const Way& way) {
    if (const auto ends = feasible_f(way)) {
      region.f_lower = std::min(ends->low, region.f_lower.value_or(HUGE_VAL));
      region.f_upper = std::max(ends->high, region.f_upper.value_or(0));
    }
    return true;
  });
  region.feasible = region.f_lower.has_value();
  region.conflict = region.feasible ? Conflict::none : conflict_of_ways(problem, limits, edge);
  return region;
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
  if (!is_plain(problem, limits)) {
    return region_of_ways(problem, limits);
  }
  const Edges edge = edges(problem, limits);
  Region region = region_edges(problem, limits);
  region.beta_min = least_beta(problem);
  region.conflict = conflict_of(problem, edge, limits);
  region.feasible = region.conflict == Conflict::none;
  if (region.feasible) {
    const double upper = highest_centre(edge.f_cap, limits.tolerance);
    const double lower = std::max(lowest_centre(region.f2, limits.tolerance),
                                  lower_end_from_stop(problem, edge, limits.tolerance));
    region.f_upper = upper;
    region.f_lower = std::min(lower, upper);  // both may be one point, rounded two ways
  }
  if (problem.arrivals > 1) {
    add_later_strips(region, problem, limits);
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
      const auto [least, most] =
          told_apart(problem.v0, passing_speeds(problem, last, f, delta).pass);
      return problem.v0 >= passing_speeds(problem, last, f, delta).pass
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
      told_apart(delta1(problem, f * (1 - limits.tolerance)), edge.delta_cap);
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
  return WideArc(problem, f).published();
}

std::optional<double> delta1_exact(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  if (f > edges(problem, {}).f3) {
    return std::nullopt;
  }
  return WideArc(problem, f).exact();
}

double delta1(const Problem& problem, double f) {
  return problem.criterion == Criterion::published ? delta1_published(problem, f)
                                                   : delta1_exact(problem, f).value_or(0);
}

RegionAnswer answer(const RegionRequest& request) {
  const auto& [problem, limits, f, delta] = request;
  if (delta && !f) {
    throw InputError::missing("f", "delta alone is no point of the region, give f as well");
  }
  const Region region = admissible_region(problem, limits);
  RegionAnswer answer{{region, reason(region, problem, limits), mends(problem, limits),
                       joint_mend(problem, limits)}};
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

}  // namespace stillpoint::design
