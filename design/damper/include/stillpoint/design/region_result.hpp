// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/motion_energies.hpp>
#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/design/constraints.hpp>
#include <stillpoint/design/practice.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/strips.hpp>
#include <stillpoint/design/works_for.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::design {

/// The least change of one input, with the others unchanged, that makes the region not empty.
struct Mend {
  /// v0 (for a pulse k, lambda), p, beta, f_max, delta_max, acceleration_max, tolerance or
  /// arrivals.
  std::string_view field;
  double value{0};
  bool upwards{false};    ///< it must increase, not decrease
  std::string in_case{};  ///< as that of a Constraint
};

/// A region. If it is empty, `reason` says why, `most_tolerant` how much tolerance there is, and
/// `mends` what would help.
struct RegionVerdict {
  Region region;
  std::optional<std::string> reason{};
  std::vector<Mend> mends{};
  std::optional<DesignPoint> most_tolerant{};  ///< not for the parts of a catalogue
  std::optional<double> largest_tolerance{};   ///< region.hpp; of a hit, where no mend helps
  /// With a pulse, of the f for which the motion returns, stays within beta and meets the limits:
  /// the region is then that of the forced motion itself.
  std::optional<std::vector<Interval>> intervals{};
  /// The exact criterion, if it alone makes the region not empty, or admits a part, where the
  /// published one does not.
  std::optional<Criterion> criterion_mend{};
  /// With a pulse: the search for some mends was given up, because it would have taken too long.
  bool mends_cut_short{false};
};

/// A region, and a damper to compare with it.
struct RegionRequest {
  Problem problem;
  Limits limits{};
  std::optional<double> f{};
  std::optional<double> delta{};  ///< with f only
  std::optional<Pulse> pulse{};   ///< in place of problem.v0
  PulseRanges pulse_ranges{};
};

/// What the answer of a design or a region tells of a damper. For a region delta1 needs only f, and
/// works_for and practice need a damper that is admissible itself.
struct Judged {
  /// The one at which it stops the mass (with ranges: after the strongest hit); empty for a rest
  /// off centre, within the residual, and of one that is not admissible.
  std::optional<std::int64_t> arrival{};
  std::vector<Constraint> constraints{};
  std::optional<double> delta1_published{};  ///< the least Delta for this f; of a pulse as the next
  std::optional<double> delta1_exact{};      ///< also empty if the motion does not return
  std::optional<WorksFor> works_for{};
  std::optional<MotionEnergies> energies{};  ///< of the motion, wherever there is one
  std::optional<double> stroke_worst{};      ///< of the box that its tolerance grants
  std::optional<Practice> practice{};        ///< of the motion
  std::optional<Practice> practice_worst{};  ///< for ranges of a hit, of their ends
  std::optional<double> notch_width_min{};   ///< as in practice, enough for all ranges
};

/// The region, and where the damper stands in it. Under a pulse, strips and arrival are
/// empty; Delta1 is the least Delta, by either criterion, that stops the mass at its first return.
struct RegionAnswer : RegionVerdict, Judged {
  std::vector<Strip> strips{};
  std::vector<Interval> feasible_f{};  ///< with the tolerance asked for, in rising order
  /// With the f of the request; without one with every feasible f, where that is known.
  std::optional<std::vector<Interval>> feasible_delta{};
  std::optional<bool> admissible{};   ///< this and what follows with f and delta
  std::optional<double> tolerance{};  ///< the largest that the damper has
  /// Of the motion, with ranges that of the strongest hit and the softest spring. Empty if it has
  /// too many half-cycles.
  std::optional<Response> response{};
  std::optional<PulseMotion> under_pulse{};  ///< the same motion under a pulse
};

}  // namespace stillpoint::design
