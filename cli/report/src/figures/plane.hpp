// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace stillpoint::report
