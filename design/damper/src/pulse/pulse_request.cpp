// SPDX-License-Identifier: MIT
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/design_result.hpp>

#include <fmt/format.h>

namespace stillpoint::design {

PulseRequest pulse_request(const DesignRequest& request) {
  const auto& [problem, limits, options, pulse, ranges] = request;
  if (problem.arrivals > 1) {
    throw InputError("arrivals", fmt::format("{}", problem.arrivals),
                     "must be 1 with a pulse: a design for a pulse stops at the first arrival");
  }
  if (problem.residual) {
    throw InputError("residual", *problem.residual,
                     "must be left out with a pulse: a design for a pulse stops at x = 0");
  }
  return {pulse_problem(problem, *pulse, ranges), limits, options};
}

PulseRequest pulse_request(const RegionRequest& request) {
  return pulse_request(
      DesignRequest{request.problem, request.limits, {}, request.pulse, request.pulse_ranges});
}

}  // namespace stillpoint::design
