// SPDX-License-Identifier: MIT
#pragma once

#include "units.hpp"

#include <stillpoint/design/record_design.hpp>
#include <stillpoint/figures/figure.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace stillpoint::report {

using Window = std::array<Interval, 2>;  // of f and delta

/// The values of the objective where every limit is met, the damper's own included, which may be
/// better than any cell; none if least > most.
struct ShownValues {
  double least{HUGE_VAL};
  double most{0};
};

[[nodiscard]] ShownValues shown_values(const design::SuiteMap& map,
                                       const design::SuiteFigures& of_damper,
                                       const design::RecordDesignRequest& task);

/// The objective over that part of the plane, for the spring and the width of the damper, the worst
/// over the tolerance about each place or each place itself; without an id and a title.
[[nodiscard]] figures::Figure drawn_map(const design::RecordDesign& result, const Window& window,
                                        bool boxes, const FigureUnits& units);

/// The plane of f and delta where the objective is good, then what lies about the damper; none if
/// f or delta was not searched.
[[nodiscard]] std::vector<figures::Figure> record_maps(const design::RecordDesign& result,
                                                       const FigureUnits& units);

}  // namespace stillpoint::report
