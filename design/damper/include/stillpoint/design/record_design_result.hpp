// SPDX-License-Identifier: MIT
#pragma once

// What a design under records is: docs/records-design.md.

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/finding.hpp>
#include <stillpoint/design/region_result.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/suite_task.hpp>
#include <stillpoint/design/works_for.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// In which motion of its case each figure is the largest there, as suite_figure_kinds.
using MotionsOfWorst = std::array<std::size_t, suite_figure_kinds.size()>;

/// The dampers that were tried around a design: a sample, no proof unless `exact`.
struct SuiteBox {
  Interval f;
  Interval delta;
  Interval p;
  Interval width;
  std::int64_t samples{0};
  bool exact{false};  ///< whether none can be worse
  TaskFigures worst;  ///< the largest of each figure
  std::vector<WorstDampers> of{};
  std::vector<MotionsOfWorst> in{};
};

struct RecordFinding {
  SuitePoint point;                                    ///< the damper itself with its own figures
  std::vector<std::vector<ForcedResponse>> responses;  ///< of each motion of each case
  std::vector<std::vector<MotionEnergies>> energies;   ///< the same
  SuiteBox box;
  SuiteOutlook outlook;
  CrossCheck cross_check;
  /// Of a damper without its tolerance: factors on the load of every case, and the p of the spring.
  std::optional<WorksFor> works_for;
  bool admissible{true};  ///< a damper that is judged need not be
  std::string part{};     ///< of the catalogue
};

/// Of a damper with that f, a range in which each delta is feasible.
struct FeasibleDelta {
  double f{0};
  Interval delta;
};
struct FeasibleRegion {
  std::vector<Interval> f;
  std::vector<FeasibleDelta> deltas;  ///< of some f from end to end
};

struct RecordDesign {
  RecordDesignRequest request;  ///< with the ranges and the combination that were chosen
  std::optional<RecordFinding> finding;
  /// That of the finding, or else the one whose box violates the limits least; with the worst of
  /// its box.
  SuitePoint nearest;
  std::optional<FeasibleRegion> region;  ///< where that is what is asked for, and nothing else
  /// The largest tolerance that was found within the limits, if that was searched: with the
  /// objective `robust`, or because no damper has the box.
  std::optional<double> largest_tolerance;
  std::vector<Constraint> constraints;  ///< the limits, and the worst of the box of `nearest`
  /// Each limit that is the only one to be relaxed so that a damper is found, and how far.
  std::vector<Mend> mends;
  SearchRecord search{.algorithm = "boxes", .scan = SearchRecord::Scan()};
  std::vector<Finding> findings;
  std::vector<RatedPart> parts;       ///< of a catalogue, best first
  std::vector<SuitePoint> trade_off;  ///< with the worst of each box, by rising stroke
};

}  // namespace stillpoint::design
