// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/region_answer.hpp>

namespace stillpoint::design {

RegionAnswer answer(const RegionRequest& request) {
  const auto& [problem, limits, f, delta] = request;
  if (delta && !f) {
    throw InputError::missing("f", "delta alone is no point of the region, give f as well");
  }
  RegionAnswer answer;
  answer.region = admissible_region(problem, limits);
  answer.reason = reason(answer.region, problem, limits);
  answer.mends = mends(problem, limits);
  answer.joint_mend = joint_mend(problem, limits);
  if (f) {
    answer.delta1_published = delta1_published(problem, *f);
    answer.delta1_exact = delta1_exact(problem, *f);
  }
  if (f && delta) {
    answer.constraints = constraints(problem, limits, *f, *delta);
    answer.tolerance = largest_tolerance(problem, limits, *f, *delta);
    answer.admissible = admissible(problem, limits, *f, *delta);
  }
  return answer;
}

}  // namespace stillpoint::design
