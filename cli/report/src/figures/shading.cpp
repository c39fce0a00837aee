// SPDX-License-Identifier: MIT
#include "figures/shading.hpp"

#include "format.hpp"

#include <algorithm>
#include <utility>

namespace stillpoint::report {

namespace {

/// The cell and those of its colour that it is connected with along sides, in ascending order;
/// they are marked as seen.
std::vector<std::size_t> area_of(const figures::FigureMap& map, std::size_t cell,
                                 std::vector<bool>& seen) {
  const auto columns = static_cast<std::size_t>(map.columns);
  std::vector<std::size_t> area{cell};
  seen[cell] = true;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const std::size_t at = area[i];
    const auto visit = [&](bool exists, std::size_t next) {
      if (exists && !seen[next] && map.cells[next] == map.cells[cell]) {
        seen[next] = true;
        area.push_back(next);
      }
    };
    visit(at % columns > 0, at - 1);
    visit((at + 1) % columns > 0, at + 1);
    visit(at >= columns, at - columns);
    visit(at + columns < map.cells.size(), at + columns);
  }
  std::ranges::sort(area);
  return area;
}

/// "≈ 20.8 mm", or "0.72–20.8 mm" where they differ by more than a tenth.
std::string words_of(std::vector<double> values, const std::function<std::string(double)>& words) {
  constexpr double much = 1.1;
  std::ranges::sort(values);
  std::string least = words(values.front());
  const std::string most = words(values.back());
  if (least == most || values.back() <= much * values.front()) {
    return "≈ " + words(values[values.size() / 2]);
  }
  const std::size_t unit = std::min(most.find(' '), most.size());
  if (least.ends_with(most.substr(unit))) {
    least.resize(least.size() - (most.size() - unit));
  }
  return format("{}–{}", least, most);
}

}  // namespace

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

void label_values(figures::FigureMap& map, const Entries& entries,
                  const std::vector<double>& values,
                  const std::function<std::string(double)>& words) {
  const std::size_t least = map.cells.size() / 50;  // smaller ones have no room
  std::vector<bool> seen(map.cells.size());
  for (std::size_t cell = 0; cell < map.cells.size(); ++cell) {
    if (seen[cell] || map.cells[cell] < entries.first || map.cells[cell] >= entries.last) {
      continue;
    }
    std::vector<std::size_t> area = area_of(map, cell, seen);
    if (area.size() < least) {
      continue;
    }
    std::vector<double> of_area;
    of_area.reserve(area.size());
    for (const std::size_t at : area) {
      of_area.push_back(values[at]);
    }
    map.values.push_back({words_of(std::move(of_area), words), std::move(area)});
  }
}

}  // namespace stillpoint::report
