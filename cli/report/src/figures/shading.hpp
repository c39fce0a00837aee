// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

/// The bounds of classes that hold equally many of the values; empty without any.
[[nodiscard]] std::vector<double> even_bounds(std::vector<double> values, std::size_t classes);

/// "#rrggbb", of several one behind the other.
[[nodiscard]] std::string shade_of(std::string_view colours, std::size_t index);

/// Of a value between the first bound and the last; a bound belongs to the class below it.
[[nodiscard]] std::size_t class_of(double value, const std::vector<double>& bounds);

/// Entries of a palette.
struct Entries {
  std::size_t first;
  std::size_t last;  ///< one beyond
};
/// Labels each area of the entries with its values, one for each cell of the map.
void label_values(figures::FigureMap& map, const Entries& entries,
                  const std::vector<double>& values,
                  const std::function<std::string(double)>& words);

}  // namespace stillpoint::report
