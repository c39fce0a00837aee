// SPDX-License-Identifier: MIT
#include "finding.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/constraints.hpp>
#include <stillpoint/design/strips.hpp>

namespace stillpoint::design {

Finding finding_of(const Problem& problem, const Limits& limits, const SearchResult& found) {
  const auto& [point, record] = found;
  Finding finding;
  finding.point = point;
  finding.search = record;
  finding.arrival = arrival_of(problem, point.f, point.delta);
  finding.constraints = constraints(problem, limits, point.f, point.delta);
  const Oscillator oscillator{problem.p, point.f, point.delta};
  finding.response = free_response(oscillator, {0, problem.v0});
  finding.practice = practice(oscillator, finding.response, limits.acceleration_max);
  finding.cross_check =
      cross_check(predict(problem, point.f, point.delta), problem, point.f, point.delta);
  return finding;
}

}  // namespace stillpoint::design
