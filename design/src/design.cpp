// SPDX-License-Identifier: MIT
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/prediction.hpp>

namespace stillpoint::design {

DesignResult design(const DesignRequest& request) {
  const auto& [problem, limits, options] = request;
  DesignResult result{request, admissible_region(problem, limits), {}, {}, {}};
  if (!result.region.feasible) {
    result.reason = reason(result.region, problem, limits);
    result.mends = mends(problem, limits);
    return result;
  }
  Finding finding;
  const SearchResult found = search(problem, limits, result.region, options);
  finding.point = found.point;
  finding.search = found.record;
  finding.constraints = constraints(problem, found.point.f, found.point.delta);
  finding.response = free_response({problem.p, found.point.f, found.point.delta}, {0, problem.v0});
  finding.cross_check =
      cross_check(predict(problem, found.point.f), problem, found.point.f, found.point.delta);
  result.finding = finding;
  return result;
}

}  // namespace stillpoint::design
