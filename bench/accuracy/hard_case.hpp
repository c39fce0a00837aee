// SPDX-License-Identifier: MIT
#pragma once

// A quantity that is hard to compute, and the three ways to compute it that docs/accuracy.md
// compares.

#include "testing/exact_run.hpp"
#include "testing/random_scene.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::accuracy {

using test::Dice;
using test::Exact;

template <class Real>
using Inputs = std::vector<Real>;

struct HardCase {
  std::string name;
  std::string metric;
  std::string why;    ///< why it is hard
  std::string naive;  ///< the obvious formula; empty if there is none
  Inputs<double> inputs;
  std::function<Inputs<double>(Dice&)> neighbour;  ///< inputs as hard as those
  std::function<double(const Inputs<double>&)> kernel;
  std::function<double(const Inputs<double>&)> by_naive;  ///< empty if `naive` is
  std::function<Exact(const Inputs<Exact>&)> exact;
  int neighbours{2000};
  bool alike{false};  ///< most neighbours have about the condition number of `inputs`
};

/// The result of a case. Errors are in units in the last place of the expected value.
struct Finding {
  double expected{0};
  double error{0};
  double condition{0};  ///< sum over the inputs of |input / value * d value / d input|
  double worst{0};      ///< largest error of the neighbours
  /// The same over the neighbour's condition number where that is above 1: about the relative
  /// change of the inputs, in units of 2^-53, that would explain the error.
  double worst_by_condition{0};
  std::optional<double> naive_error;
  std::optional<double> naive_worst;
};

[[nodiscard]] Finding examine(const HardCase& hard_case);

[[nodiscard]] std::vector<HardCase> free_cases();
[[nodiscard]] std::vector<HardCase> region_cases();
[[nodiscard]] std::vector<HardCase> forced_cases();

}  // namespace stillpoint::accuracy
