// SPDX-License-Identifier: MIT
#pragma once

// What is drawn of a region, and of a damper in it.

#include "units.hpp"

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/figures/figure.hpp>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stillpoint::report {

/// A point of the (f, Delta) plane and its tolerance.
struct DrawnDamper {
  std::string name;
  double f{0};
  double delta{0};
  double tolerance{0};
  bool admissible{true};
};

/// Whether it is in the region, even if it keeps less than the tolerance asked for.
[[nodiscard]] inline bool is_within(const DrawnDamper& damper) {
  return damper.admissible || damper.tolerance > 0;
}

/// A part of the plane is enlarged in a corner, unless rounding would be seen.
void add_inset(figures::Figure& figure, const figures::FigurePoint& low,
               const figures::FigurePoint& high);
/// Enlarges a box if it is too small to see, unless it is one of next to nothing.
void add_box_inset(figures::Figure& figure, const std::vector<figures::FigurePoint>& box);
/// Adds to the caption of a region which part of it is enlarged, if any.
void caption_inset(figures::Figure& figure, const FigureUnits& units);
/// The corners of its tolerance box, starting from the lower left.
[[nodiscard]] std::vector<figures::FigurePoint> tolerance_box(const DrawnDamper& damper,
                                                              const design::BoxShape& shape,
                                                              double unit);
/// "tolerance ±34.2 %", or that of f and of Delta.
[[nodiscard]] std::string tolerance_words(const design::BoxShape& shape, double tolerance);

/// The damper with its box, enlarged if it is small.
void add_damper(figures::Figure& figure, const DrawnDamper& damper, const design::BoxShape& shape,
                const FigureUnits& units);
/// What the box means, or without one the area that is left, for a caption to go on.
[[nodiscard]] std::string region_clause(const std::optional<DrawnDamper>& damper,
                                        const design::Region& region, const design::Limits& limits);

/// What to draw for a region.
struct DrawnRegion {
  design::Problem problem;
  design::Limits limits;
  design::Region region;
  std::optional<DrawnDamper> damper;
  std::string mend;  ///< the title where nothing is admissible
  std::optional<design::PulseProblem> pulse{};
  std::vector<Interval> intervals{};  ///< of f that are admissible under it
};

/// A line around each.
void add_tolerant(figures::Figure& figure, const design::Limits& limits,
                  std::vector<std::vector<figures::FigurePoint>> areas);
/// Of a stop at that arrival, in each figure; those of neighbours differ.
[[nodiscard]] figures::Ink arrival_ink(double arrival);
/// "arrivals 3, 6, 9": those of `arrivals` that have the ink of `one`; empty if it is the only one.
[[nodiscard]] std::string key_of_arrivals(const std::set<double>& arrivals, double one);
/// The admissible region in the (f, Delta) plane, its forbidden sides in words, and a point in it.
[[nodiscard]] figures::Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units);

/// Where the mass stops, by the velocity of the hit, and which of them the damper works for.
[[nodiscard]] figures::Figure hits_figure(const design::Problem& problem,
                                          const design::Limits& limits, double f, double delta,
                                          const std::optional<design::WorksFor>& works_for,
                                          const FigureUnits& units);
/// The same by the strength of a pulse, at the first return.
[[nodiscard]] figures::Figure strengths_figure(const design::PulseProblem& problem, double f,
                                               double delta,
                                               const std::optional<design::WorksFor>& works_for);

/// The analytic boundaries alone, within the axes of the figure.
void add_boundaries(figures::Figure& figure, const design::Problem& problem,
                    const FigureUnits& units, const figures::FigurePoint& last);

}  // namespace stillpoint::report
