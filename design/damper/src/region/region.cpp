// SPDX-License-Identifier: MIT
#include <stillpoint/design/region.hpp>

#include "found.hpp"
#include "pulse/answer.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <fmt/format.h>

#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

std::optional<Response> response_of(const Oscillator& oscillator, double v0) {
  constexpr double most_half_cycles = 1e6;  // a few milliseconds, and far from any design
  try {
    return free_response(oscillator, {0, v0}, {.half_cycle_limit = most_half_cycles});
  } catch (const TooManyHalfCycles&) {
    return std::nullopt;
  }
}

std::vector<Interval> feasible_at(const RegionAnswer& answer, const RegionRequest& request,
                                  double f) {
  std::vector<Interval> all;
  const auto add = [&all](const std::optional<Interval>& delta) {
    if (delta && (delta->low < delta->high || delta->low == 0)) {  // delta > low
      all.push_back(*delta);
    }
  };
  if (request.pulse) {
    add(feasible_delta(pulse_request(request).problem, request.limits)(f));
  }
  for (const Strip& strip : answer.strips) {
    add(feasible_delta(request.problem, request.limits, strip.arrival, f));
  }
  return merged(std::move(all));
}

/// What f and Delta are feasible, where the region and the strips are known.
void add_feasible(RegionAnswer& answer, const RegionRequest& request) {
  const auto& [problem, limits, f, delta, pulse, ranges] = request;
  const bool feasible = answer.region.feasible;
  const bool first = problem.arrivals == 1 && !problem.residual;
  if (feasible) {
    answer.feasible_f =
        pulse || first ? std::vector<Interval>{{*answer.region.f_lower, *answer.region.f_upper}}
                       : feasible_f(answer.strips);
  }
  // With a single arrival the least Delta falls with f: what suits the least f suits every other.
  const bool falls = !pulse && first && problem.v0_low != 0.0;
  if (delta || (feasible && (f || falls))) {
    answer.feasible_delta = feasible_at(answer, request, f ? *f : *answer.region.f_lower);
  }
}

}  // namespace

void explain(RegionVerdict& empty, const Problem& problem, const Limits& limits) {
  empty.reason = reason(empty.region, problem, limits);
  empty.mends = mends(problem, limits);
  empty.most_tolerant = most_tolerant(problem, limits);
  empty.criterion_mend = criterion_mend(problem, limits);
  if (empty.mends.empty() && !empty.criterion_mend) {
    empty.largest_tolerance = largest_tolerance_of_any(problem, limits);
  }
}

RegionAnswer answer(const RegionRequest& request) {
  const auto& [problem, limits, f, delta, pulse, ranges] = request;
  if (delta && !f) {
    throw InputError::missing("f", "delta alone is not a damper: give f as well");
  }
  if (pulse) {
    RegionAnswer answer = answer_under_pulse(request);
    add_feasible(answer, request);
    return answer;
  }
  const Region region = admissible_region(problem, limits);
  if (f) {
    require_valid(Oscillator{problem.p, *f, delta.value_or(0)});
  }
  RegionAnswer answer{{region}, {}};
  if (!region.feasible) {
    explain(answer, problem, limits);
  }
  answer.strips = strips(problem, limits);
  add_feasible(answer, request);
  if (f) {
    add_delta1(answer, problem, *f);
  }
  if (f && delta) {
    answer.constraints = constraints(problem, limits, *f, *delta);
    Limits even = limits;
    even.shape = {};
    answer.tolerance = largest_tolerance(problem, even, *f, *delta);
    answer.admissible = admissible(problem, limits, *f, *delta);
    answer.arrival = *answer.admissible ? arrival_of(problem, *f, *delta) : std::nullopt;
    answer.works_for = works_for(problem, limits, *f, *delta);
    const Oscillator oscillator{problem.p, *f, *delta};
    answer.response = response_of(oscillator, problem.v0);
    if (answer.response) {
      answer.energies = motion_energies(oscillator, {0, problem.v0}, NoExcitation());
    }
    if (answer.works_for && answer.response) {
      add_practice(answer, problem, limits, {*f, *delta, answer.tolerance.value_or(0)},
                   *answer.response);
    }
  }
  return answer;
}

std::string summary(const RegionVerdict& verdict) {
  const Region& region = verdict.region;
  return region.feasible ? fmt::format("admissible for f from {:.6g} to {:.6g}", *region.f_lower,
                                       *region.f_upper)
                         : "no damper: " + verdict.reason.value();
}

}  // namespace stillpoint::design
