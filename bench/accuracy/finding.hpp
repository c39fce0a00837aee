// SPDX-License-Identifier: MIT
#pragma once

#include "hard_case.hpp"

#include <optional>

namespace stillpoint::accuracy {

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

}  // namespace stillpoint::accuracy
