// SPDX-License-Identifier: MIT
#pragma once

#include "request.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/half_cycle_walk.hpp>
#include <stillpoint/design/design.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::cli {

/// What `region` answers.
struct RegionAnswer {
  design::Region region;
  std::string reason;
  std::vector<design::Mend> mends;
  std::optional<design::JointMend> joint_mend;
  std::optional<double> delta1_published;
  std::optional<double> delta1_exact;
  std::optional<bool> admissible;
  std::optional<double> tolerance;  ///< the largest that the point withstands
  std::vector<design::Constraint> constraints;
};

/// What `simulate` answers.
struct SimulateAnswer {
  Response response;
  std::optional<ForcedResponse> forced;  ///< where there is an excitation; response is its part
  std::vector<HalfCycle> half_cycles;
  std::optional<std::string> trajectory;  ///< the file's text, where one was asked for
};

/// Parts of more than one report.
[[nodiscard]] nlohmann::ordered_json program_json();
[[nodiscard]] nlohmann::ordered_json simulate_input_json(const SimulateInput& input);

/// The reports that docs/reports.md describes. Numbers carry a double's full precision; a value
/// that does not exist is null; a number that is not finite is an assertion.
[[nodiscard]] nlohmann::ordered_json design_json(const DesignInput& input,
                                                 const design::DesignResult& result);
[[nodiscard]] nlohmann::ordered_json region_json(const RegionInput& input,
                                                 const RegionAnswer& answer);
[[nodiscard]] nlohmann::ordered_json simulate_json(const SimulateInput& input,
                                                   const SimulateAnswer& answer);

}  // namespace stillpoint::cli
