// SPDX-License-Identifier: MIT
// The maps of a design under records.
#include "figures/region_figures.hpp"
#include "figures/report_figures.hpp"

#include <stillpoint/design/suite_view.hpp>

#include <array>

namespace stillpoint::report {

namespace {

using design::SuiteCell;
using design::SuiteView;

/// The objective from least to largest, then what is broken, from the least excess to the largest.
constexpr std::array shades{"#0b4f8a", "#2f7fc1", "#6aaede", "#9ecae9", "#c6dff2", "#e6f1fa"};
constexpr std::size_t excesses = 4;
struct Fault {
  const char* name;
  std::string_view colours;
};
constexpr auto faults =
    std::to_array<Fault>({{"stroke too large", "#fbd9b5#f5b06a#e88432#c05a10"},
                          {"transmits too much", "#f6d3d6#e8a5ad#d37583#a94459"},
                          {"residual too large", "#eee0c2#d9bd8a#b9935a#8a6636"},
                          {"jump too large", "#ddd3ea#bda9d6#9a80bf#6f529b"},
                          {"passes x = 0 too often", "#d5e3d0#a9c69f#7ba36d#51793f"},
                          {"takes too long", "#d3dfe3#a3bcc6#7397a6#4a6f7f"},
                          {"never rests, or rests too late", "#8a7a68#8a7a68#8a7a68#8a7a68"}});
static_assert(faults.size() == design::suite_figure_kinds.size() + 1);
constexpr std::size_t never = faults.size() - 1;

/// Of one shade.
double shade_width(const Interval& values) {
  return values.high > values.low ? (values.high - values.low) / static_cast<double>(shades.size())
                                  : 1;
}

/// The shade of its value, or that of its excess in the colour of the limit that it exceeds most.
std::uint8_t cell_shade(const SuiteCell& cell, const Interval& values,
                        const std::vector<double>& bounds) {
  const double place = (cell.value - values.low) / shade_width(values);
  return static_cast<std::uint8_t>(
      cell.excess == 0 ? std::min(static_cast<std::size_t>(place), shades.size() - 1)
                       : shades.size() + excesses * cell.fault +
                             (cell.fault == never ? 0 : class_of(cell.excess, bounds)));
}

void add_shades(FigureMap& drawn, const Interval& values, const design::SuiteFigureKind& kind,
                const FigureUnits& units) {
  const auto& [least, most] = values;
  const Unit unit = units.of(kind.dimension);
  for (std::size_t i = 0; i < shades.size(); ++i) {
    const double from = least + shade_width(values) * static_cast<double>(i);
    const double to = std::min(from + shade_width(values), most);
    drawn.palette.push_back(from <= to ? shade(shades.at(i), "", from * unit, to * unit, unit.name)
                                       : MapShade{shades.at(i)});
  }
  if (least < most) {
    drawn.key.push_back({shades.front(), "from " + unit.words(least)});
    drawn.key.push_back({shades.back(), "to " + unit.words(most)});
  } else if (least == most) {
    drawn.key.push_back({shades.front(), unit.words(least)});
  }
}

void add_faults(FigureMap& drawn, const std::vector<double>& bounds) {
  for (const auto& [name, colours] : faults) {
    const std::size_t first = drawn.palette.size();
    for (std::size_t i = 0; i < excesses; ++i) {
      drawn.palette.push_back({shade_of(colours, i),
                               name == faults[never].name || bounds.empty()
                                   ? name
                                   : format("{}, {} to {} over the limits", name,
                                            part_words(bounds[i]), part_words(bounds[i + 1])),
                               name, Hatch::one_way});
    }
    if (std::ranges::any_of(drawn.cells, [first](std::uint8_t cell) {
          return first <= cell && cell < first + excesses;
        })) {
      drawn.key.push_back({shade_of(colours, 1), name, "", Hatch::one_way});
    }
  }
}

/// What the shades of the hatched areas mean.
std::string excess_clause(const std::vector<double>& bounds, std::string_view where) {
  return bounds.empty() || bounds.front() == bounds.back()
             ? ""
             : format("{}the darker, the more the limits are exceeded, by {} to {} in all", where,
                      part_words(bounds.front()), part_words(bounds.back()));
}

/// Without an id and a title.
Figure drawn_map(const design::RecordDesign& result, const SuiteView& view, bool boxes,
                 const FigureUnits& units) {
  const design::SuiteFigureKind& kind = minimised(result.request);
  const Unit& unit = units.length;
  Figure figure;
  figure.x = {units.f_label, view.f.low, view.f.high};
  figure.y = {units.delta_label, view.delta.low * unit, view.delta.high * unit};
  const std::vector<double> bounds = even_bounds(view.excesses(), excesses);
  figure.map.columns = figure.map.rows = static_cast<std::int64_t>(view.side);
  for (const SuiteCell& cell : view.cells) {
    figure.map.cells.push_back(cell_shade(cell, view.values, bounds));
  }
  add_shades(figure.map, view.values, kind, units);
  const std::size_t of_good = figure.map.key.size();
  add_faults(figure.map, bounds);
  const FigurePoint place{result.nearest.damper.f, result.nearest.damper.delta * unit};
  const char* const what = result.finding ? "chosen" : "nearest";
  figure.marks.push_back({what, {place}, Shape::star, Ink::orange});
  figure.notes.push_back({what, place});
  if (result.finding && result.finding->box.f.low < result.finding->box.f.high &&
      result.finding->box.delta.low < result.finding->box.delta.high) {
    const design::SuiteBox& box = result.finding->box;
    Points outline = rectangle(box.f.low, box.f.high, box.delta.low * unit, box.delta.high * unit);
    outline.push_back(outline.front());
    figure.add_line("the tolerance", {std::move(outline)}, Ink::orange);
  }
  figure.description =
      format("The plane of f and Δ: the {} of the {}{}, and where a limit is violated.", kind.words,
             result.request.cases.size() == 1 ? "records combined" : "worst case",
             boxes ? ", the worst over the tolerance" : "");
  const bool any_fails = figure.map.key.size() > of_good;
  figure.clauses = {
      !view.any_good() ? "Each area is named after the limit exceeded most there"
      : any_fails      ? "A cell that is not hatched meets every limit in its middle, the "
                         "darker the better"
                       : "The darker, the better",
      any_fails ? excess_clause(bounds, view.any_good() ? "where it is hatched, " : "") : ""};
  if (boxes && !result.request.tolerance.exact()) {
    figure.clauses.emplace_back("a cell shows the worst within the tolerance about its middle");
  }
  if (result.finding && figure.map.cells[view.cell(result.nearest.damper)] != 0) {
    figure.clauses.emplace_back("the damper found is better than the middle of its cell");
  }
  return figure;
}

/// "No damper: allow a stroke of 62.1 mm": the first limit that would be enough alone.
std::string shortfall_title(const design::RecordDesign& result, const FigureUnits& units) {
  if (result.mends.empty()) {
    return "No damper meets the limits";
  }
  const design::Mend& mend = result.mends.front();
  const auto& kind =
      *std::ranges::find(design::suite_figure_kinds, mend.field, &design::SuiteFigureKind::field);
  return format("No damper: allow a {} of {}{}", kind.words,
                units.of(kind.dimension).words(mend.value),
                mend.in_case.empty() ? "" : " in " + mend.in_case);
}

/// Where the search went beyond the map; "" if nowhere.
std::string beyond_words(const design::RecordDesignRequest& task, const SuiteView& view,
                         const FigureUnits& units) {
  std::string ends;
  if (view.f.low > task.f->low || view.f.high < task.f->high) {
    ends = format("f = {:.3g} to {:.3g}", task.f->low, task.f->high);
  }
  if (view.delta.low > task.delta->low || view.delta.high < task.delta->high) {
    ends += format("{}Δ = {} to {}", ends.empty() ? "" : " and ",
                   units.place_words(task.delta->low), units.place_words(task.delta->high));
  }
  return ends.empty() ? "" : "the search went beyond this map, over " + ends;
}

/// The feasible delta of each f, joined to that of the next.
Figure region_outline(const design::FeasibleRegion& region, const FigureUnits& units) {
  constexpr double beyond = 1.15;
  const Unit& unit = units.length;
  std::vector<std::vector<Interval>> columns;
  std::vector<double> places;
  double most = 0;
  for (const auto& [f, delta] : region.deltas) {
    if (places.empty() || places.back() != f) {
      places.push_back(f);
      columns.emplace_back();
    }
    columns.back().push_back(delta);
    most = std::max(most, delta.high * unit);
  }
  Figure figure;
  figure.id = "region";
  figure.title = "Which dampers are feasible";
  figure.description = "The plane of f and Δ, and the part in which every limit is met.";
  figure.clauses = {format("Through the feasible Δ of {} values of f", places.size())};
  figure.x = {units.f_label, 0, beyond * region.f.back().high};
  figure.y = {units.delta_label, 0, beyond * most};
  const double half = (places.back() - places.front()) / static_cast<double>(places.size() - 1) / 2;
  for (std::size_t from = 0, end = 0; from < columns.size(); from = end) {
    const std::size_t ranges = columns[from].size();
    while (end < columns.size() && columns[end].size() == ranges) {
      ++end;
    }
    // Halfway to where there are more ranges, or fewer.
    const double left = places[from] - (from > 0 ? half : 0);
    const double right = places[end - 1] + (end < columns.size() ? half : 0);
    for (std::size_t k = 0; k < ranges; ++k) {
      design::PlaneArea area;
      area.columns.push_back({left, columns[from][k]});
      for (std::size_t i = from; i < end; ++i) {
        area.columns.push_back({places[i], columns[i][k]});
      }
      area.columns.push_back({right, columns[end - 1][k]});
      figure.areas.push_back({"feasible", outline(area, unit.factor), Ink::sky});
    }
  }
  return figure;
}

}  // namespace

std::vector<Figure> record_maps(const design::RecordDesign& result, const FigureUnits& units) {
  const design::RecordDesignRequest& task = result.request;
  std::vector<Figure> maps;
  if (result.region) {
    if (!result.region->f.empty() && result.region->f.front().low < result.region->f.back().high) {
      maps.push_back(region_outline(*result.region, units));
    }
    return maps;
  }
  if (const auto view = overview(result)) {
    Figure& figure = maps.emplace_back(drawn_map(result, *view, true, units));
    figure.id = "map";
    figure.title = !result.finding
                       ? shortfall_title(result, units)
                       : format("The {} {}", minimised(task).words,
                                task.p.low < task.p.high ? "at the best period" : "over f and Δ");
    figure.clauses.push_back(beyond_words(task, *view, units));
  }
  if (const auto view = close_up(result)) {
    Figure& figure = maps.emplace_back(drawn_map(result, *view, false, units));
    figure.id = "map-near";
    figure.title = "Each damper by itself";
    figure.folded = "Without any error of f and Δ";
    figure.clauses.emplace_back("the box is what the design may become");
  }
  return maps;
}

}  // namespace stillpoint::report
