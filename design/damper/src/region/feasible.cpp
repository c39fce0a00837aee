// SPDX-License-Identifier: MIT
#include "region/feasible.hpp"

#include <stillpoint/design/design_result.hpp>

#include <algorithm>
#include <utility>

namespace stillpoint::design {

namespace {

/// In rising order, without those that overlap.
std::vector<Interval> merged(std::vector<Interval> all) {
  std::ranges::sort(all, {}, &Interval::low);
  std::vector<Interval> apart;
  for (const Interval& now : all) {
    if (!apart.empty() && now.low <= apart.back().high) {
      apart.back().high = std::max(apart.back().high, now.high);
    } else {
      apart.push_back(now);
    }
  }
  return apart;
}

/// Of a region that is not empty.
std::vector<Interval> feasible_f(const RegionAnswer& answer, const RegionRequest& request) {
  const Problem& problem = request.problem;
  if (request.pulse || (problem.arrivals == 1 && !problem.residual)) {
    return {{*answer.region.f_lower, *answer.region.f_upper}};
  }
  std::vector<Interval> all;
  for (const Strip& strip : answer.strips) {
    if (strip.f_lower) {
      all.push_back({*strip.f_lower, *strip.f_upper});
    }
  }
  return merged(std::move(all));
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

}  // namespace

void add_feasible(RegionAnswer& answer, const RegionRequest& request) {
  const auto& [problem, limits, f, delta, pulse, ranges] = request;
  const bool feasible = answer.region.feasible;
  if (feasible) {
    answer.feasible_f = feasible_f(answer, request);
  }
  // With a single arrival the least Delta falls with f: what suits the least f suits every other.
  const bool falls = !pulse && problem.arrivals == 1 && !problem.residual && problem.v0_low != 0.0;
  if (delta || (feasible && (f || falls))) {
    answer.feasible_delta = feasible_at(answer, request, f ? *f : *answer.region.f_lower);
  }
}

}  // namespace stillpoint::design
