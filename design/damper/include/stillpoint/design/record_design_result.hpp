// SPDX-License-Identifier: MIT
#pragma once

// What a design under records is: docs/records-design.md.

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/suite_check.hpp>
#include <stillpoint/design/suite_task.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::design {

struct SuiteSearchCost {
  std::int64_t evaluations{0};
  double wall_time_s{0};
  std::int64_t scan_points{0};
  std::int64_t scan_feasible{0};  ///< boxes of the scan within the limits
  bool interrupted{false};        ///< the best so far; a whole search may find a better one
};

/// The dampers that were tried around a design: a sample, not a proof.
struct SuiteBox {
  Interval f;
  Interval delta;
  Interval p;
  Interval width;
  std::int64_t samples{0};
  SuiteFigures worst;                                       ///< the largest of each figure
  std::array<SuiteDamper, suite_figure_kinds.size()> of{};  ///< where, as suite_figure_kinds
};

struct RecordFinding {
  SuitePoint point;                       ///< the damper itself with its own figures
  std::vector<ForcedResponse> responses;  ///< of each record
  SuiteBox box;
  SuiteOutlook outlook;
  SuiteCheck check;
};

/// A limit, if the box of no damper met all of them.
struct SuiteShortfall {
  const SuiteFigureKind* kind{nullptr};
  double limit{0};
  double nearest{0};      ///< the worst in the box that violates the limits least
  std::size_t record{0};  ///< under which that is largest
  /// The value to which this limit alone must be relaxed to find a damper; empty: none was found.
  std::optional<double> relaxed;
};

struct RecordDesign {
  RecordDesignRequest request;  ///< with the ranges and the combination that were chosen
  std::optional<RecordFinding> finding;
  /// That of the finding, or else the one whose box violates the limits least; with the worst of
  /// its box.
  SuitePoint nearest;
  /// The largest tolerance that was found within the limits, if that was searched: with the
  /// objective `robust`, or because no damper has the box.
  std::optional<double> largest_tolerance;
  std::vector<SuiteShortfall> shortfalls;
  SuiteSearchCost search;
  std::vector<Finding> findings;
};

}  // namespace stillpoint::design
