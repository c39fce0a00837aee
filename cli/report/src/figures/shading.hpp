// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <cstddef>
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

/// A shade of cells with values from `low` to `high`, written among them: "0.21 to 0.233 g", or
/// "≈ 0.222 g" of those that hardly differ.
[[nodiscard]] figures::MapShade shade(std::string colour, const std::string& name, double low,
                                      double high, const std::string& unit,
                                      figures::Hatch hatch = figures::Hatch::none);

}  // namespace stillpoint::report
