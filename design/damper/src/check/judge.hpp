// SPDX-License-Identifier: MIT
#pragma once

#include "check/runge_kutta.hpp"

#include <stillpoint/core/seconds.hpp>
#include <stillpoint/design/check_method.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/problem.hpp>

#include <string_view>

namespace stillpoint::design {

/// How accurate a method is. Below the decision margin `resolution` its own errors may change a
/// decision.
struct Quality {
  std::string_view name;
  double tolerance;
  double resolution;
  bool acceleration{true};  ///< compared as well
};

/// Completes a method whose figures are already computed; `margin` is the decision margin of the
/// predicted motion.
void judge(CheckMethod& method, const Quality& quality, const Prediction& prediction,
           const Problem& problem, double f, double delta, double margin);

/// Copies the figures of a motion.
void take(CheckMethod& method, const IntegratedMotion& motion);

/// Runs it and returns how long that took, in seconds.
template <class Run>
double timed(const Run& run) {
  const double started = seconds_now();
  run();
  return seconds_now() - started;
}

}  // namespace stillpoint::design
