// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

/// The bounds of classes that hold equally many of the values; empty without any.
[[nodiscard]] inline std::vector<double> even_bounds(std::vector<double> values,
                                                     std::size_t classes) {
  std::vector<double> bounds;
  for (std::size_t i = 0; !values.empty() && i <= classes; ++i) {
    const auto bound =
        values.begin() + static_cast<std::ptrdiff_t>(i * (values.size() - 1) / classes);
    std::nth_element(values.begin(), bound, values.end());
    bounds.push_back(*bound);
  }
  return bounds;
}

/// "#rrggbb", of several one behind the other.
[[nodiscard]] inline std::string shade_of(std::string_view colours, std::size_t index) {
  constexpr std::size_t length = 7;
  return std::string(colours.substr(length * index, length));
}

/// Of a value between the first bound and the last; a bound belongs to the class below it.
[[nodiscard]] inline std::size_t class_of(double value, const std::vector<double>& bounds) {
  const auto inner = std::lower_bound(bounds.begin() + 1, bounds.end() - 1, value);
  return static_cast<std::size_t>(inner - bounds.begin()) - 1;
}

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
