// SPDX-License-Identifier: MIT
#pragma once

// What a damper for records does if it is not built exactly: docs/records-design.md section 3.

#include <stillpoint/design/suite_task.hpp>

#include <cstdint>
#include <optional>

namespace stillpoint::design {

/// A damper beside the design.
struct MuchWorse {
  double change{0};  ///< of f, delta or both, relative
  SuiteFigures figures;
};

/// The stroke from which the spring pulls the mass back with a thousandth of the load: with less it
/// hardly moves.
[[nodiscard]] double hardly_moving_stroke(double p, double load);

/// Whether it never rests, or has half as much again of the objective, or than a limit allows. A
/// stroke or residual with which it hardly moves does not count, nor a residual below a hundredth
/// of the stroke of the design.
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

}  // namespace stillpoint::design
