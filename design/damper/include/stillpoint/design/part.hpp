// SPDX-License-Identifier: MIT
#pragma once

// The parts of a catalogue, and how they fit a task.

#include <stillpoint/design/constraints.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

/// A damper as it is sold.
struct Part {
  std::string name;
  double f{0};
  double delta{0};
};

/// A box around it stays within what f and Delta may be.
inline constexpr double largest_part_value = 1e299;

/// How well a part fits a task.
struct RatedPart {
  Part part;
  bool admissible{false};           ///< with the tolerance asked for
  std::optional<double> tolerance;  ///< the largest; empty if the part itself is not admissible
  /// What the part itself violates; empty if it only lacks the tolerance asked for.
  std::vector<Constraint> violated;
};

}  // namespace stillpoint::design
