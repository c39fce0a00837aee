// SPDX-License-Identifier: MIT
#include "figures/record_map.hpp"
#include "figures/shading.hpp"
#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;

namespace {

using design::SuiteFigures;
using design::SuiteLimits;

/// The objective from least to largest, then what is broken, from the least excess to the largest.
constexpr std::array shades{"#0b4f8a", "#2f7fc1", "#6aaede", "#9ecae9", "#c6dff2", "#e6f1fa"};
constexpr std::size_t excesses = 4;
constexpr std::array<std::string_view, 5> broken{
    "#fbd9b5#f5b06a#e88432#c05a10", "#f6d3d6#e8a5ad#d37583#a94459", "#eee0c2#d9bd8a#b9935a#8a6636",
    "#ddd3ea#bda9d6#9a80bf#6f529b", "#8a7a68#8a7a68#8a7a68#8a7a68"};
constexpr std::array broken_names{"stroke too large", "transmits too much", "residual too large",
                                  "jump too large", "never rests, or rests too late"};
constexpr std::size_t never = broken.size() - 1;

/// Of broken_names, in the order of design::suite_figure_kinds, the one whose limit is exceeded
/// most; their number where the limits are met.
std::size_t broken_index(const SuiteFigures& figures, const SuiteLimits& limits) {
  if (admissible(figures, limits)) {
    return broken.size();
  }
  std::size_t worst = never;
  double most = 0;
  for (std::size_t i = 0; figures.settled && i < never; ++i) {
    SuiteLimits one;
    one.*design::suite_figure_kinds.at(i).limit = limits.*design::suite_figure_kinds.at(i).limit;
    if (const double over = excess(figures, one); over > most) {
      most = over;
      worst = i;
    }
  }
  return worst;
}

/// Of one shade.
double shade_width(const ShownValues& shown) {
  return shown.most > shown.least ? (shown.most - shown.least) / static_cast<double>(shades.size())
                                  : 1;
}

/// The bounds of the shades of what exceeds a limit.
std::vector<double> excess_bounds(const design::SuiteMap& map, const SuiteLimits& limits) {
  std::vector<double> all;
  for (const SuiteFigures& figures : map.figures) {
    if (broken_index(figures, limits) < never) {
      all.push_back(excess(figures, limits));
    }
  }
  std::ranges::sort(all);  // a value that many have is in one shade
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return even_bounds(std::move(all), excesses);
}

/// Each cell has the shade of its value, or that of its excess in the colour of the limit that it
/// exceeds most.
void add_cells(figures::FigureMap& drawn, const design::SuiteMap& map, const ShownValues& shown,
               const std::vector<double>& bounds, const design::RecordDesignRequest& task) {
  drawn.columns = static_cast<std::int64_t>(map.f.size());
  drawn.rows = static_cast<std::int64_t>(map.delta.size());
  for (std::size_t row = 0; row < map.delta.size(); ++row) {
    for (std::size_t column = 0; column < map.f.size(); ++column) {
      const SuiteFigures& figures = map.figures[column * map.delta.size() + row];
      const std::size_t fault = broken_index(figures, task.limits);
      const double place = (figures.*minimised(task).value - shown.least) / shade_width(shown);
      const std::size_t shade =
          fault == broken.size() ? std::min(static_cast<std::size_t>(place), shades.size() - 1)
          : fault == never
              ? shades.size() + excesses * never
              : shades.size() + excesses * fault + class_of(excess(figures, task.limits), bounds);
      drawn.cells.push_back(static_cast<std::uint8_t>(shade));
    }
  }
}

void add_shades(figures::FigureMap& drawn, const ShownValues& shown,
                const design::SuiteFigureKind& kind, const FigureUnits& units) {
  const auto& [least, most] = shown;
  const auto [unit, name] = units.of(kind.dimension);
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const double from = least + shade_width(shown) * static_cast<double>(i);
    const double to = std::min(from + shade_width(shown), most);
    drawn.palette.push_back(from <= to ? shade(shades.at(i), "", from * unit, to * unit, name)
                                       : figures::MapShade{shades.at(i)});
  }
  if (least < most) {
    drawn.key.push_back({"from " + units.of(kind.dimension).words(least), shades.front()});
    drawn.key.push_back({"to " + units.of(kind.dimension).words(most), shades.back()});
  } else if (least == most) {
    drawn.key.push_back({units.of(kind.dimension).words(least), shades.front()});
  }
}

/// Of the cell that the damper lies in.
std::uint8_t shade_at(const Figure& drawn, const figures::FigurePoint& place) {
  const auto cell = [](double position, std::int64_t count) {
    return std::clamp(static_cast<std::int64_t>(position * static_cast<double>(count)),
                      std::int64_t{0}, count - 1);
  };
  const std::int64_t row = cell(drawn.y.position(place.y), drawn.map.rows);
  const std::int64_t column = cell(drawn.x.position(place.x), drawn.map.columns);
  return drawn.map.cells[static_cast<std::size_t>(row * drawn.map.columns + column)];
}

/// "3 %", "2500 %"
std::string excess_words(double excess) {
  constexpr double whole = 0.1;
  return excess < whole ? format("{:.2g} %", 100 * excess) : format("{:.0f} %", 100 * excess);
}

/// Whether there are any.
bool add_faults(figures::FigureMap& drawn, const std::vector<double>& bounds) {
  bool any = false;
  for (std::size_t i = 0; i < broken.size(); ++i) {
    const std::string name = broken_names.at(i);
    bool there = false;
    for (std::size_t shade = 0; shade < excesses; ++shade) {
      const auto index = static_cast<std::uint8_t>(drawn.palette.size());
      there = there || std::ranges::count(drawn.cells, index) > 0;
      drawn.palette.push_back(
          {shade_of(broken.at(i), shade),
           i == never || bounds.empty()
               ? name
               : format("{}, {} to {} over the limits", name, excess_words(bounds[shade]),
                        excess_words(bounds[shade + 1])),
           name, figures::Hatch::one_way});
    }
    if (there) {
      drawn.key.push_back({name, shade_of(broken.at(i), 1), figures::Hatch::one_way});
      any = true;
    }
  }
  return any;
}

/// What the shades of the hatched areas mean.
std::string excess_clause(const std::vector<double>& bounds, std::string_view where) {
  return bounds.empty() || bounds.front() == bounds.back()
             ? ""
             : format("{}the darker, the more the limits are exceeded, by {} to {} in all", where,
                      excess_words(bounds.front()), excess_words(bounds.back()));
}

}  // namespace

ShownValues shown_values(const design::SuiteMap& map, const SuiteFigures& of_damper,
                         const design::RecordDesignRequest& task) {
  ShownValues shown;
  const auto include = [&](const SuiteFigures& figures) {
    if (admissible(figures, task.limits)) {
      shown.least = std::min(shown.least, figures.*minimised(task).value);
      shown.most = std::max(shown.most, figures.*minimised(task).value);
    }
  };
  include(of_damper);
  std::ranges::for_each(map.figures, include);
  return shown;
}

Figure drawn_map(const design::RecordDesign& result, const Window& window, bool boxes,
                 const FigureUnits& units) {
  const design::SuitePoint& point = result.nearest;
  design::RecordDesignRequest task = result.request;
  std::tie(task.f, task.delta) = std::pair(window[0], window[1]);
  const design::SuiteMap map = design::suite_map(task, point.damper, boxes);
  const SuiteFigures& own =
      boxes || !result.finding ? point.figures : result.finding->point.figures;
  const ShownValues values = shown_values(map, own, task);
  Figure figure;
  figure.x = {units.f_label, task.f->low, task.f->high};
  figure.y = {units.delta_label, task.delta->low * units.length, task.delta->high * units.length};
  const std::vector<double> bounds = excess_bounds(map, task.limits);
  add_cells(figure.map, map, values, bounds, task);
  add_shades(figure.map, values, minimised(task), units);
  const bool any_fails = add_faults(figure.map, bounds);
  const figures::FigurePoint place{point.damper.f, point.damper.delta * units.length};
  const char* const what = result.finding ? "chosen" : "nearest";
  figure.marks.push_back({what, {place}, figures::Shape::star, figures::Ink::orange});
  figure.notes.push_back({what, place});
  figure.description = format(
      "The plane of f and Δ: the {} of the records combined{}, and where a limit is "
      "violated.",
      minimised(task).words, boxes ? ", the worst over the tolerance" : "");
  const bool any_good = values.least <= values.most;
  figure.clauses = {
      !any_good   ? "Each area is named after the limit exceeded most there"
      : any_fails ? "A cell that is not hatched meets every limit in its middle, the "
                    "darker the better"
                  : "The darker, the better",
      any_fails ? excess_clause(bounds, any_good ? "where it is hatched, " : "") : ""};
  if (boxes && !task.tolerance.exact()) {
    figure.clauses.emplace_back("a cell shows the worst within the tolerance about its middle");
  }
  constexpr std::uint8_t best_shade = 0;
  if (result.finding && shade_at(figure, place) != best_shade) {
    figure.clauses.emplace_back("the damper found is better than the middle of its cell");
  }
  return figure;
}

}  // namespace stillpoint::report
