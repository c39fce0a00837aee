// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/seconds.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/problem.hpp>

#include <initializer_list>
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

/// Judges a method by the error of its peak and, if it is decided, the others. `same_end`: it ends
/// like the expected motion.
void conclude(CheckMethod& method, bool same_end, double error_of_peak,
              std::initializer_list<double> others);

/// The figures of a motion.
[[nodiscard]] MotionFigures checked_figures(const Response& response);

/// A method with the figures that `run` gives, and how long that took.
template <class Run>
CheckMethod measured(const Run& run) {
  CheckMethod method;
  const double started = seconds_now();
  static_cast<MotionFigures&>(method) = run();
  method.wall_time_s = seconds_now() - started;
  return method;
}

}  // namespace stillpoint::design
