// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_scan.hpp"

#include <cstdint>
#include <string>

namespace stillpoint::design {

/// The best point found, by the scan or by NLopt from its best.
struct SuiteOptimum {
  SuitePoint point;
  std::string algorithm;
  std::string status;
  std::int64_t evaluations{0};  ///< NLopt's
};

/// About how many dampers that takes.
[[nodiscard]] std::int64_t usual_evaluations(const SuiteBox& box);

[[nodiscard]] SuiteOptimum optimum(const Suite& suite, const SuiteBox& box, const SuiteScan& scan,
                                   SuiteObjective objective, const SuiteLimits& limits,
                                   const Threads& threads, SuiteWatch& watch);

}  // namespace stillpoint::design
