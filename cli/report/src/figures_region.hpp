// SPDX-License-Identifier: MIT
#pragma once

#include "units.hpp"

#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/figures/figure.hpp>

#include <functional>
#include <optional>
#include <string>

namespace stillpoint::report {

/// A point of the (f, Delta) plane and the tolerance it withstands.
struct DrawnDamper {
  std::string name;
  double f{0};
  double delta{0};
  double tolerance{0};
};

/// The problem at a constant friction f: another one for each f where a pulse leaves the velocity.
using ProblemAt = std::function<design::Problem(double)>;

/// What there is to draw of a region.
struct DrawnRegion {
  design::Problem problem;
  design::Limits limits;
  design::Region region;
  std::optional<DrawnDamper> damper;
  std::optional<design::PulseProblem> pulse;
};

/// The admissible region in the (f, Delta) plane, its edges by name, and a point in it.
[[nodiscard]] figures::Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units);

/// The analytic boundaries alone, within the axes of the figure.
void add_boundaries(figures::Figure& figure, const design::Problem& problem,
                    const FigureUnits& units);

}  // namespace stillpoint::report
