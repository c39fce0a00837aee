// SPDX-License-Identifier: MIT
#pragma once

// The best damper for a suite of recorded accelerations: docs/records-design.md.

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/suite_check.hpp>
#include <stillpoint/design/suite_sensitivity.hpp>
#include <stillpoint/design/suite_task.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::design {

struct SuiteSearch {
  std::string algorithm;  ///< which found the point: "scan", "LN_SBPLX" or "GN_ISRES"
  std::string status;     ///< NLopt's own; "SUCCESS" for the scan
  std::int64_t evaluations{0};
  double wall_time_s{0};
  std::int64_t scan_points{0};
  std::int64_t scan_feasible{0};
  bool interrupted{false};  ///< the best so far; a whole search may find a better one
};

struct RecordFinding {
  SuitePoint point;
  std::vector<ForcedResponse> responses;  ///< of each record
  Sensitivity sensitivity;
  SuiteCheck check;
};

/// A limit, if no damper met all of them.
struct SuiteShortfall {
  SuiteObjective which{SuiteObjective::acceleration};
  double limit{0};
  double nearest{0};  ///< the figure of the damper that violates the limits least
  /// The value to which this limit alone must be relaxed to find a damper; empty: none was found.
  std::optional<double> relaxed;
};

struct RecordDesign {
  RecordDesignRequest request;  ///< with the ranges and the combination that were chosen
  std::optional<RecordFinding> finding;
  SuitePoint nearest;  ///< that of the finding, or else the one that violates the limits least
  std::vector<SuiteShortfall> shortfalls;
  SuiteSearch search;
};

/// One line.
[[nodiscard]] std::string summary(const RecordDesign& result);

/// Scan, NLopt, check. Finding no damper is a result. Throws InputError.
[[nodiscard]] RecordDesign design(const RecordDesignRequest& request,
                                  const RecordWatch& go_on = {});

/// The figures of a damper for `request` as in a RecordDesign. Throws InputError.
[[nodiscard]] SuiteFigures figures_of(const RecordDesignRequest& request,
                                      const SuiteDamper& damper);

/// The figures over f and delta for one p, in the middles of even cells: delta runs faster.
struct SuiteMap {
  std::vector<double> f;
  std::vector<double> delta;
  std::vector<SuiteFigures> figures;
};
/// For `request` as in a RecordDesign, with `side` cells along each. Throws InputError.
[[nodiscard]] SuiteMap suite_map(const RecordDesignRequest& request, double p, int side = 60);

}  // namespace stillpoint::design
