// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/pulse_check.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/search.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

struct DesignRequest {
  Problem problem;
  Limits limits{};
  SearchOptions search{};
  std::optional<Pulse> pulse{};  ///< in place of problem.v0; see pulse_design.hpp
};

/// The design found for an admissible region.
struct Finding {
  DesignPoint point;
  std::vector<Constraint> constraints;
  Response response;  ///< by the half-cycle map
  SearchRecord search;
  CrossCheck cross_check;
  std::optional<PulseCheck> pulse;  ///< if a pulse gave the initial velocity
};

/// The whole answer to a request, repeated with the v0 that a pulse leaves. Without a finding the
/// region is empty: `reason` says why and `mends`, or else `joint_mend`, what would help.
struct DesignResult {
  DesignRequest request;
  Region region;
  std::string reason;
  std::vector<Mend> mends;
  std::optional<Finding> finding;
  std::optional<JointMend> joint_mend{};
};

/// The result in one line for people: the damper and its motion, or why there is none.
[[nodiscard]] std::string summary(const DesignResult& result);

/// Region, search, simulation, cross-check. Throws InputError for wrong input; an empty region and
/// a failed check are results.
[[nodiscard]] DesignResult design(const DesignRequest& request);

}  // namespace stillpoint::design
