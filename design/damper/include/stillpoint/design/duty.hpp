// SPDX-License-Identifier: MIT
#pragma once

// What a damper has to stand, for those who build it.

#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/design/practice.hpp>
#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/shown_damper.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

/// Of one case of a task.
struct Duty {
  std::string motion{};                  ///< of several, the one that moves the mass farthest
  std::size_t index{0};                  ///< which it is
  double stroke{0};                      ///< of several records combined as asked
  std::optional<double> stroke_worst{};  ///< of the dampers that the tolerance allows
  double peak_velocity{0};               ///< of any of its motions
  Energies most{};                       ///< each the largest of its motions, up to the rest
  std::optional<FullCycle> cycle{};      ///< between plus and minus the stroke
};

[[nodiscard]] Duty duty_of(const ShownDamper& damper);
/// Of each case of a design with a damper.
[[nodiscard]] std::vector<Duty> duties_of(const RecordDesign& design);

}  // namespace stillpoint::design
