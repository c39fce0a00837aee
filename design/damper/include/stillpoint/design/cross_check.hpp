// SPDX-License-Identifier: MIT
#pragma once

// The prediction of a design, checked by other methods.

#include <stillpoint/design/prediction.hpp>
#include <stillpoint/design/problem.hpp>

#include <vector>

namespace stillpoint::design {

struct CrossCheck {
  bool passed{false};
  std::vector<CheckMethod> methods;
};

/// Compares the prediction with the half-cycle map (tolerance 1e-12) and with Runge-Kutta
/// (1e-9; integrated at 1e-12). Where the arrival grazes x = 0, the stop time loses up to half of
/// its digits in any arithmetic; both tolerances are multiplied by (31) of docs/theory.md, which is
/// 1 away from there; for later arrivals by (53). Throws InputError for delta = 0, which is not a
/// design.
[[nodiscard]] CrossCheck cross_check(const Prediction& prediction, const Problem& problem, double f,
                                     double delta);

}  // namespace stillpoint::design
