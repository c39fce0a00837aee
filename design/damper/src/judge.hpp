// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/problem.hpp>

#include <string_view>

namespace stillpoint::design {

/// How exact a method is. Below the decision margin `resolution` its own errors may change a
/// decision.
struct Quality {
  std::string_view name;
  double tolerance;
  double resolution;
  bool acceleration{true};  ///< compared as well
};

/// Completes a method whose figures are already there; `margin` is the decision margin of the
/// predicted motion.
void judge(CheckMethod& method, const Quality& quality, const Prediction& prediction,
           const Problem& problem, double f, double margin);

}  // namespace stillpoint::design
