// SPDX-License-Identifier: MIT
#pragma once

#include "figure.hpp"
#include "figure_units.hpp"

#include <stillpoint/design/region.hpp>

#include <optional>

namespace stillpoint::cli {

/// A point of the (f, Delta) plane and the tolerance it withstands.
struct DrawnDamper {
  std::string name;
  double f{0};
  double delta{0};
  double tolerance{0};
};

/// The admissible region in the (f, Delta) plane, its edges by name, and a point in it.
[[nodiscard]] Figure region_figure(const design::Problem& problem, const design::Limits& limits,
                                   const design::Region& region,
                                   const std::optional<DrawnDamper>& damper,
                                   const FigureUnits& units);

/// The analytic boundaries alone, within the axes of the figure.
void add_boundaries(Figure& figure, const design::Problem& problem, const FigureUnits& units);

}  // namespace stillpoint::cli
