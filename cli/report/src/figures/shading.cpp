// SPDX-License-Identifier: MIT
#include "figures/shading.hpp"

#include "format.hpp"
#include "units.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <utility>

namespace stillpoint::report {

std::vector<double> even_bounds(std::vector<double> values, std::size_t classes) {
  std::vector<double> bounds;
  for (std::size_t i = 0; !values.empty() && i <= classes; ++i) {
    const auto bound =
        values.begin() + static_cast<std::ptrdiff_t>(i * (values.size() - 1) / classes);
    std::nth_element(values.begin(), bound, values.end());
    bounds.push_back(*bound);
  }
  return bounds;
}

std::string shade_of(std::string_view colours, std::size_t index) {
  constexpr std::size_t length = 7;
  return std::string(colours.substr(length * index, length));
}

std::size_t class_of(double value, const std::vector<double>& bounds) {
  const auto inner = std::lower_bound(bounds.begin() + 1, bounds.end() - 1, value);
  return static_cast<std::size_t>(inner - bounds.begin()) - 1;
}

figures::MapShade shade(std::string colour, const std::string& name, double low, double high,
                        const std::string& unit, figures::Hatch hatch) {
  constexpr double much = 1.1;
  const std::string values =
      (low < high ? interval_digits(low, high) : few_digits(high)) + with_blank(unit);
  return {std::move(colour), name + values,
          high < much * low ? format("≈ {:.3g}{}", (low + high) / 2, with_blank(unit)) : values,
          hatch};
}

}  // namespace stillpoint::report
