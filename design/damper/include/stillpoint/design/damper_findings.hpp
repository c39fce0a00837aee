// SPDX-License-Identifier: MIT
#pragma once

// What a damper for hits or pulses must say beyond its figures.

#include <stillpoint/design/built_notch.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/region.hpp>

#include <optional>
#include <vector>

namespace stillpoint::design {

/// What a result does not know of its task.
struct AskedWith {
  bool weight{false};  ///< in metres and seconds, so that f is a share of the weight
  bool a_part{false};  ///< of a catalogue, which is what it is
};

/// Of a design, with the notch that will be built if that is known; nothing without a damper.
[[nodiscard]] std::vector<Finding> findings_of(const DesignResult& design,
                                               const std::optional<BuiltNotch>& built,
                                               const AskedWith& asked = {});
/// Of a damper that a region judges; nothing without one.
[[nodiscard]] std::vector<Finding> findings_of(const RegionRequest& request,
                                               const RegionAnswer& answer,
                                               const AskedWith& asked = {});

/// Whether the best f is none at all: a limit that a search comes near and nobody builds.
[[nodiscard]] bool wants_no_friction(const DesignResult& design);
/// The friction to build, in as few digits from six on as leave it feasible; none if less is
/// better.
[[nodiscard]] std::optional<double> told_f(const DesignResult& design);

}  // namespace stillpoint::design
