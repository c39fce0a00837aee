// SPDX-License-Identifier: MIT
#include "record/suite_check.hpp"

#include "check/runge_kutta.hpp"

#include <stillpoint/core/seconds.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

double relative(double error, double size) {
  return size > 0 ? std::abs(error) / size : std::abs(error);
}

}  // namespace

CrossCheck check(const Suites& suites, const SuiteDamper& damper,
                 const std::vector<std::vector<ForcedResponse>>& responses) {
  const double begun = seconds_now();
  CheckMethod method;
  method.name = "runge_kutta";
  method.tolerance = 1e-6;
  method.passed = true;
  for (std::size_t c = 0; c < responses.size(); ++c) {
    const Suite& suite = suites.cases()[c];
    for (std::size_t i = 0; i < responses[c].size(); ++i) {
      const CaseMotion& motion = suite.motions()[i];
      const SuiteFigures kernel = suite_figures(responses[c][i]);
      const SuiteFigures other = integrate_to_rest(suite.oscillator(damper), Suite::surface(damper),
                                                   motion.load, motion.start);
      const double error =
          std::max({relative(other.peak - kernel.peak, kernel.peak),
                    relative(other.acceleration - kernel.acceleration, kernel.acceleration),
                    relative(other.residual - kernel.residual, kernel.peak)});
      method.motions.push_back({other.peak, other.acceleration, other.residual, error});
      method.relative_error = std::max(method.relative_error, error);
      method.passed = method.passed && other.settled && error <= method.tolerance;
    }
  }
  method.wall_time_s = seconds_now() - begun;
  return {method.passed, {method}};
}

}  // namespace stillpoint::design
