// SPDX-License-Identifier: MIT
#include <stillpoint/design/cross_check.hpp>

#include "check/judge.hpp"
#include "check/runge_kutta.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

namespace stillpoint::design {

namespace {

/// 2e-16 (2 + n) with n = 2 and some room.
constexpr Quality map_quality{"half_cycle_map", 1e-12, 1e-15};
/// Resolution: the energy error that a thousand steps at this tolerance may add up to.
constexpr double integrator_tolerance = 1e-12;
constexpr Quality runge_kutta_quality{"runge_kutta", 1e-9, 1000 * integrator_tolerance};
/// Where it disagrees, it integrates again: what is left is not its own error.
constexpr double closer_tolerance = 1e-14;

}  // namespace

CrossCheck cross_check(const Prediction& prediction, const Problem& problem, double f,
                       double delta) {
  require_within("delta", delta, 0, largest_square);
  const Oscillator oscillator{problem.p, f, delta};
  double margin = 0;

  CheckMethod map = measured([&] {
    const Response response = free_response(oscillator, {0, problem.v0});
    margin = response.decision_margin.value_or(0);
    return checked_figures(response);
  });
  judge(map, map_quality, prediction, problem, f, delta, margin);

  const auto by_runge_kutta = [&](double tolerance) {
    CheckMethod method =
        measured([&] { return integrate_free_motion(oscillator, problem.v0, tolerance); });
    judge(method, runge_kutta_quality, prediction, problem, f, delta, margin);
    return method;
  };
  CheckMethod integrated = by_runge_kutta(integrator_tolerance);
  if (!integrated.passed) {
    integrated = by_runge_kutta(closer_tolerance);
  }

  return {map.passed && integrated.passed, {map, integrated}};
}

}  // namespace stillpoint::design
