// SPDX-License-Identifier: MIT
#pragma once

// The best damper for a suite of recorded accelerations: docs/records-design.md.

#include <stillpoint/design/record_design_result.hpp>
#include <stillpoint/design/suite_task.hpp>

#include <string>
#include <vector>

namespace stillpoint::design {

/// One line.
[[nodiscard]] std::string summary(const RecordDesign& result);

/// Scan, refinement, verification, check. Finding no damper is a result. Throws InputError.
[[nodiscard]] RecordDesign design(const RecordDesignRequest& request,
                                  const RecordWatch& go_on = {});

/// Of a design with a damper: the motion of a case with the largest figure of the objective, or of
/// several the one with the largest stroke.
[[nodiscard]] std::size_t worst_motion(const RecordDesign& result, std::size_t in_case);

/// The constraint of a case that leaves it the least part of its limit, and the damper of the box
/// that does.
struct Governing {
  const Constraint& constraint;
  double part_left{0};  ///< of the limit; where that is 0, and broken, the slack
  SuiteDamper damper;
};
/// Of a design with a damper; empty if the case has no limit above 0 and breaks none.
[[nodiscard]] std::optional<Governing> governing(const RecordDesign& result, std::size_t in_case);

/// The figures of a damper for `request` as in a RecordDesign. Throws InputError.
[[nodiscard]] TaskFigures figures_of(const RecordDesignRequest& request, const SuiteDamper& damper);

/// The figures over f and delta, with the period and the width of `damper`, in the middles of even
/// cells: delta runs faster.
struct SuiteMap {
  std::vector<double> f;
  std::vector<double> delta;
  std::vector<TaskFigures> figures;
};
/// For `request` as in a RecordDesign, with `side` cells along each: the worst over the box of each
/// place by the dampers of the map in it, or that of the place alone if not `boxes`. Throws
/// InputError.
[[nodiscard]] SuiteMap suite_map(const RecordDesignRequest& request, const SuiteDamper& damper,
                                 bool boxes, int side = 60);

}  // namespace stillpoint::design
