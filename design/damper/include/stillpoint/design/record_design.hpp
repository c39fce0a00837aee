// SPDX-License-Identifier: MIT
#pragma once

// The best damper for a suite of recorded accelerations: docs/records-design.md.

#include <stillpoint/core/forced_motion.hpp>
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

/// A damper beside the design.
struct MuchWorse {
  double change{0};  ///< of f, delta or both, relative
  SuiteFigures figures;
};

/// The stroke from which the spring pulls the mass back with a thousandth of the load: with less it
/// hardly moves.
[[nodiscard]] double hardly_moving_stroke(double p, double load);

/// Whether it never rests, or has half as much again of the objective, or than a limit allows. A
/// stroke or residual with which it hardly moves does not count, nor a residual below a hundredth of
/// the stroke of the design.
[[nodiscard]] bool is_much_worse(const SuiteFigures& figures, const SuitePoint& chosen,
                                 const RecordDesignRequest& request);

/// The least constant friction of any part: rolling bearings have 0.001 to 0.005.
inline constexpr double least_friction = 0.002;

/// What dampers within f (1 +- R), delta (1 +- R) do, at the corners and random points: a sample,
/// not a proof.
struct Sensitivity {
  double tolerance{0};
  std::int64_t samples{0};
  std::int64_t admissible{0};  ///< of the samples
  SuiteFigures worst;  ///< the largest of each figure, of the damper itself too; settled if all are
  /// The nearest that was found with f, delta or both off by R/2^k, which random points would miss.
  std::optional<MuchWorse> much_worse;
  /// With that f, if the design has less and they violate a limit or are a tenth worse.
  std::optional<SuiteFigures> with_least_friction;
};

/// One record by another integrator, and its distance from the kernel.
struct SuiteCheckRow {
  double peak{0};
  double acceleration{0};
  double residual{0};
  double relative_error{0};  ///< of peak and acceleration; of residual over the peak
};

/// Runge-Kutta with a fixed step, events bisected; it shares only the rules with the kernel.
struct SuiteCheck {
  bool passed{false};
  double tolerance{1e-6};  ///< for relative_error
  double relative_error{0};
  double wall_time_s{0};
  std::vector<SuiteCheckRow> records;
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

/// How many dampers the scan of that design has.
[[nodiscard]] std::int64_t scan_size(const RecordDesignRequest& request);
/// The figures of the dampers first <= i < first + count of that scan; fewer after a stop. They do
/// not depend on other dampers, so a scan may be computed in parts. Throws InputError.
[[nodiscard]] std::vector<SuiteFigures> scan_part(const RecordDesignRequest& request,
                                                  std::int64_t first, std::int64_t count,
                                                  const RecordWatch& go_on = {});
/// The same design from the figures of its whole scan, to the last bit. Throws InputError, also if
/// their number is not scan_size(request).
[[nodiscard]] RecordDesign design(const RecordDesignRequest& request,
                                  const std::vector<SuiteFigures>& scanned,
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
