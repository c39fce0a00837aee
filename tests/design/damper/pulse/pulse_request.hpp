// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/design.hpp>

namespace stillpoint::design_test {

/// With p = 1, by the exact criterion and without limits.
inline design::PulseRequest request_of(const design::Pulse& pulse, double beta,
                                       design::Objective objective = design::Objective::robust) {
  design::PulseRequest request;
  request.problem = {pulse, 1, beta, design::Criterion::exact};
  request.search.objective = objective;
  return request;
}

}  // namespace stillpoint::design_test
