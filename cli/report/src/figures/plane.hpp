// SPDX-License-Identifier: MIT
#pragma once

#include "figures/region_figures.hpp"
#include "units.hpp"

#include <stillpoint/design/plane.hpp>
#include <stillpoint/figures/figure.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

/// What the names of areas tell.
struct PlaneWords {
  std::string beta;
  std::string_view hits{};
  std::int64_t arrivals{1};
  bool residual{false};
  std::string_view beyond{};  ///< the limit that bounds f

  explicit PlaneWords(std::string limit) : beta(std::move(limit)) {}
  PlaneWords(const design::Problem& problem, const design::Limits& limits,
             const FigureUnits& units);
};

[[nodiscard]] std::vector<figures::FigurePoint> outline(const design::PlaneArea& area, double unit);
/// Named, in their colours.
void add_areas(figures::Figure& figure, const std::vector<design::PlaneArea>& areas,
               const PlaneWords& words, double unit);

/// Enlarges a strip too thin to see, where it is thickest. The legend names it.
void add_strip_inset(figures::Figure& figure, const design::PlaneArea& strip, double unit);
/// Enlarges a point whose mark would hide the strip, or the gap between strips, that it lies in.
void add_point_inset(figures::Figure& figure, const std::vector<design::PlaneArea>& areas,
                     const DrawnDamper& damper, double unit);

}  // namespace stillpoint::report
