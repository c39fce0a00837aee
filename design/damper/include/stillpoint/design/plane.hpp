// SPDX-License-Identifier: MIT
#pragma once

// The plane of f and Delta of a task: what is admissible, and what forbids the rest; docs/theory.md
// sections 7, 12 and 13.

#include <stillpoint/design/admissible_region.hpp>
#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/pulse.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace stillpoint::design {

enum class PlaneKind {
  any_rest,              ///< admissible: any rest is within the residual
  arrival,               ///< the mass stops at the n-th one
  later_arrivals,        ///< from the n-th to the last: thin strips with gaps
  admissible,            ///< under a pulse
  too_weak,              ///< f: the peak exceeds beta
  too_strong,            ///< f: the weakest hit does not come back, whatever Delta is
  dead_zone,             ///< f: wider than beta
  never_starts,          ///< f is more than the pulse
  too_weak_and_strong,   ///< f: both
  held_at_start,         ///< Delta: the weakest hit does not leave the notch
  too_weak_and_limited,  ///< f: too weak, and beyond the limit of f
  beyond_limit,          ///< f: the least of the limits
  misses_limits,         ///< under a pulse
  exceeds_everywhere,    ///< under a pulse: as too weak, but more friction does not help
  notch_too_weak,        ///< Delta: the strongest hit passes the last arrival allowed
  by_criterion_alone,    ///< stops, but not by the published criterion
  above_delta_max,
  notch_too_weak_and_limited,
  off_centre,  ///< some hit rests there, or beyond the residual
};

/// Of one kind, in columns beside each other.
struct PlaneArea {
  struct Column {
    double f{0};
    Interval delta{};
  };
  PlaneKind kind{PlaneKind::arrival};
  std::int64_t arrival{0};  ///< of a strip
  std::vector<Column> columns{};

  /// Its range at an f; empty outside it.
  [[nodiscard]] std::optional<Interval> at(double f) const;
};

struct PlaneWindow {
  Interval f;
  Interval delta;
};

/// Where an area has its largest range, and the f whose edges lie in that.
[[nodiscard]] PlaneWindow thickest_part(const PlaneArea& area);
/// The nearest edges below a point and above it; infinite without one.
[[nodiscard]] Interval edges_about(const std::vector<PlaneArea>& areas, double f, double delta);
/// What lies beyond the largest f that the limits allow; empty without one.
[[nodiscard]] std::string_view beyond_limits(const Problem& problem, const Limits& limits);

/// Strips that can be told apart; those of later arrivals are one area.
inline constexpr std::int64_t most_shown_strips = 12;

/// The strip of each arrival within the limits, regardless of the tolerance, that of `last`, if it
/// has one, behind the others.
[[nodiscard]] std::vector<PlaneArea> admissible_areas(const Problem& problem, const Limits& limits,
                                                      std::int64_t last = 0);
/// Of those that keep the tolerance asked for; none without one.
[[nodiscard]] std::vector<PlaneArea> tolerant_areas(const Problem& problem, const Limits& limits);
/// The rest of the window.
[[nodiscard]] std::vector<PlaneArea> forbidden_areas(const Problem& problem, const Limits& limits,
                                                     const Region& region,
                                                     const PlaneWindow& window);

/// All of the window, under a pulse, with the intervals of f that the region has.
[[nodiscard]] std::vector<PlaneArea> pulse_areas(const PulseProblem& problem, const Limits& limits,
                                                 const Region& region,
                                                 const std::vector<Interval>& intervals,
                                                 const PlaneWindow& window);
[[nodiscard]] std::vector<PlaneArea> tolerant_areas(const PulseProblem& problem,
                                                    const Limits& limits,
                                                    const std::vector<Interval>& intervals,
                                                    double delta_most);

}  // namespace stillpoint::design
