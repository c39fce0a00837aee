// SPDX-License-Identifier: MIT
#pragma once

// What is drawn of a region, and of a damper in it.

#include "figures/drawing.hpp"
#include "sections.hpp"

#include <stillpoint/design/plane.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/works_for.hpp>

#include <set>

namespace stillpoint::report {

/// A point of the (f, Delta) plane and its tolerance.
struct DrawnDamper : design::DesignPoint {
  std::string name;
  bool admissible{true};
};

/// Enlarges a box if it is too small to see, unless it is one of next to nothing.
void add_box_inset(Figure& figure, const Points& box);
/// Enlarges what of the strips would not be seen: the one that a damper's mark would hide, or the
/// gap between strips, else one that is too thin, where it is thickest, which the legend names. The
/// caption says what is enlarged.
void add_inset(Figure& figure, const std::vector<design::PlaneArea>& strips,
               const std::optional<DrawnDamper>& damper, const FigureUnits& units);
/// The corners of its tolerance box, starting from the lower left.
[[nodiscard]] Points tolerance_box(const DrawnDamper& damper, const design::BoxShape& shape,
                                   double unit);
/// "tolerance ±34.2 %", or that of f and of Delta.
[[nodiscard]] std::string tolerance_words(const design::BoxShape& shape, double tolerance);

/// The damper with its box, enlarged if it is small.
void add_damper(Figure& figure, const DrawnDamper& damper, const design::BoxShape& shape,
                const FigureUnits& units);
/// Of a stop at that arrival, in each figure; those of neighbours differ.
[[nodiscard]] Ink arrival_ink(double arrival);
/// "arrivals 3, 6, 9": those of `arrivals` that have the ink of `one`; empty if it is the only one.
[[nodiscard]] std::string key_of_arrivals(const std::set<double>& arrivals, double one);
/// The admissible region in the (f, Delta) plane, its forbidden sides in words, a point in it, and
/// the parts to choose from.
[[nodiscard]] Figure region_figure(const ShownTask& task, const design::RegionVerdict& verdict,
                                   const std::optional<DrawnDamper>& damper,
                                   const std::optional<Catalogue>& catalogue);

/// Where the mass stops, by the velocity of the hit or the strength of the pulse, and which of them
/// the damper works for.
[[nodiscard]] Figure ends_figure(const ShownTask& task, double f, double delta,
                                 const std::optional<design::WorksFor>& works_for);

/// The analytic boundaries alone, within the axes of the figure; whether that of Delta1 is seen.
bool add_boundaries(Figure& figure, const design::Problem& problem, const FigureUnits& units,
                    const FigurePoint& last);

[[nodiscard]] Points outline(const design::PlaneArea& area, double unit);
/// Named, in their colours.
void add_areas(Figure& figure, const std::vector<design::PlaneArea>& areas, const ShownTask& task,
               const FigureUnits& units);

}  // namespace stillpoint::report
