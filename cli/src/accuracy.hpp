// SPDX-License-Identifier: MIT
#pragma once

#include "request.hpp"

#include <stillpoint/peers/exact.hpp>
#include <stillpoint/peers/measure.hpp>
#include <stillpoint/peers/scene.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::cli {

/// One method with one setting, on the scene.
struct MethodFigures {
  std::string_view name;
  std::string setting;   ///< "tolerance 1e-09"; "" where it has none
  bool used{false};      ///< by simulate
  bool too_long{false};  ///< not run: it would take minutes; the rest is then empty
  peers::Timing time;    ///< seconds a call
  peers::Result result;
  double peak_error{0};  ///< absolute, dimensionless
  double end_error{0};   ///< of stop time and place; of x and v where it goes on at the end
  bool counts_right{false};
};

/// How each method does on one scene.
struct AccuracyAnswer {
  peers::Scene scene;
  peers::ExactResult exact;  ///< 50 digits
  std::vector<MethodFigures> methods;
  std::string why;  ///< simulate uses the first
};

/// Throws UsageError for a motion that never stops and one that is too long for 50 digits.
[[nodiscard]] AccuracyAnswer compare_methods(const SimulateInput& input);

}  // namespace stillpoint::cli
