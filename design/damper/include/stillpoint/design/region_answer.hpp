// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/region.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

/// A region, and a damper to hold against it.
struct RegionRequest {
  Problem problem;
  Limits limits{};
  std::optional<double> f{};
  std::optional<double> delta{};  ///< with f only
};

/// The region, what would mend an empty one, and how the damper stands in it.
struct RegionAnswer {
  Region region;
  std::string reason;
  std::vector<Mend> mends;
  std::optional<JointMend> joint_mend;
  std::optional<double> delta1_published;  ///< these two with f
  std::optional<double> delta1_exact;      ///< empty also where the motion does not return
  std::optional<bool> admissible;          ///< this and what follows with f and delta
  std::optional<double> tolerance;         ///< the largest that the damper has
  std::vector<Constraint> constraints;
};

/// Throws InputError as admissible_region does, for f or delta not in [0, 1e300], and for delta
/// without f.
[[nodiscard]] RegionAnswer answer(const RegionRequest& request);

}  // namespace stillpoint::design
