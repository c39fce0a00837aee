// SPDX-License-Identifier: MIT
#pragma once

#include "../task.hpp"

#include <stillpoint/design/design.hpp>

#include <string_view>
#include <variant>

namespace stillpoint::design_test {

/// With p = 1, by the exact criterion and without limits.
inline design::PulseRequest request_of(const design::Pulse& pulse, double beta,
                                       design::Objective objective = design::Objective::robust) {
  design::PulseRequest request;
  request.problem = {pulse, 1, beta, design::Criterion::exact};
  request.search.objective = objective;
  return request;
}

/// With what a mend says.
inline design::PulseRequest mended(design::PulseRequest request, std::string_view field,
                                   double value) {
  design::PulseProblem& problem = request.problem;
  if (field == "k" || field == "k_high") {
    std::visit([&](auto& kind) { kind.k = value; }, problem.pulse);
  } else if (field == "lambda" || field == "lambda_low") {
    std::visit([&](auto& kind) { kind.lambda = value; }, problem.pulse);
  } else if (field == "k_low") {
    problem.ranges.k_low = value;
  } else if (field == "lambda_high") {
    problem.ranges.lambda_high = value;
  } else if (field == "p" || field == "p_low") {
    problem.p = value;
  } else if (field == "p_high") {
    problem.p_high = value;
  } else if (field == "beta") {
    problem.beta = value;
  } else {
    request.limits = Task{{}, request.limits}.with(field, value).limits;
  }
  return request;
}

}  // namespace stillpoint::design_test
