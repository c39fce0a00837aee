// SPDX-License-Identifier: MIT
// Which parts of the plane of f and delta the maps of a design under records show.
#include "figures/record_map.hpp"
#include "format.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;

namespace {

void add_box_outline(Figure& figure, const design::SuiteBox& box, const FigureUnits& units) {
  const Interval& f = box.f;
  const Interval delta{box.delta.low * units.length, box.delta.high * units.length};
  if (f.low < f.high && delta.low < delta.high) {
    auto outline = figures::rectangle(f.low, f.high, delta.low, delta.high);
    outline.push_back(outline.front());
    figure.curves.push_back(
        figures::line("the tolerance", {std::move(outline)}, figures::Ink::orange));
  }
}

/// "No damper: allow a stroke of 62.1 mm": the first limit that would be enough alone.
std::string shortfall_title(const design::RecordDesign& result, const FigureUnits& units) {
  if (result.mends.empty()) {
    return "No damper meets the limits";
  }
  const design::Mend& mend = result.mends.front();
  const auto& kind =
      *std::ranges::find(design::suite_figure_kinds, mend.field, &design::SuiteFigureKind::field);
  return format("No damper: allow a {} of {}", kind.words,
                units.of(kind.dimension).words(mend.value));
}

/// Where the search went beyond the map; "" if nowhere.
std::string beyond_words(const design::RecordDesignRequest& task, const Window& window,
                         const FigureUnits& units) {
  const auto span = [](const Interval& range, const auto& words) {
    return format("{} to {}", words(range.low), words(range.high));
  };
  std::string ends;
  if (window[0].low > task.f->low || window[0].high < task.f->high) {
    ends = "f = " + span(*task.f, [](double f) { return format("{:.3g}", f); });
  }
  if (window[1].low > task.delta->low || window[1].high < task.delta->high) {
    ends += (ends.empty() ? "Δ = " : " and Δ = ") +
            span(*task.delta, [&](double delta) { return units.place_words(delta); });
  }
  return ends.empty() ? "" : format("the search went beyond this map, over {}", ends);
}

/// With a quarter more on either side, to where the search ended if that is near.
Interval with_margin(const Interval& seen, const Interval& searched) {
  constexpr double part = 0.25;
  constexpr double least_part = 0.05;
  const double margin =
      std::max(part * (seen.high - seen.low), least_part * (searched.high - searched.low));
  const Interval wide{seen.low - margin, seen.high + margin};
  return {wide.low - margin < searched.low ? searched.low : wide.low,
          wide.high + margin > searched.high ? searched.high : wide.high};
}

/// Not begun just before a round number, whose label would reach below those of the other axis.
Interval with_room_for_labels(const Interval& shown, const Interval& searched) {
  constexpr double room = 0.4;  // of the distance between labels
  const std::vector<double> ticks = figures::ticks({"", shown.low, shown.high});
  return ticks.size() < 2
             ? shown
             : Interval{std::max(searched.low,
                                 std::min(shown.low, ticks[0] - room * (ticks[1] - ticks[0]))),
                        shown.high};
}

/// The dampers that meet the limits and are nearer to the best value than to the worst, so that a
/// mass that does not move, which meets any limit of the stroke, does not fill the map.
Window good_window(const design::RecordDesign& result, const design::SuitePoint& point) {
  const design::RecordDesignRequest& task = result.request;
  constexpr int coarse = 40;
  const design::SuiteMap all = design::suite_map(task, point.damper, true, coarse);
  const ShownValues values = shown_values(all, point.figures, task);
  Interval f{point.damper.f, point.damper.f};
  Interval delta{point.damper.delta, point.damper.delta};
  for (std::size_t i = 0; i < all.figures.size(); ++i) {
    if (admissible(all.figures[i], task.limits) &&
        2 * all.figures[i].*minimised(task).value <= values.least + values.most) {
      const double at_f = all.f[i / all.delta.size()];
      const double at_delta = all.delta[i % all.delta.size()];
      f = {std::min(f.low, at_f), std::max(f.high, at_f)};
      delta = {std::min(delta.low, at_delta), std::max(delta.high, at_delta)};
    }
  }
  return {with_room_for_labels(with_margin(f, *task.f), *task.f), with_margin(delta, *task.delta)};
}

/// Of a damper that violates a limit, as all others do.
Interval about_nearest(const Interval& searched, double nearest) {
  constexpr double around = 3;
  constexpr double least_part = 0.1;
  return {searched.low,
          std::min(searched.high,
                   std::max(around * nearest,
                            searched.low + least_part * (searched.high - searched.low)))};
}

Figure overview(const design::RecordDesign& result, const FigureUnits& units) {
  const design::RecordDesignRequest& task = result.request;
  const design::SuiteDamper& damper = result.nearest.damper;
  const Window window = result.finding ? good_window(result, result.nearest)
                                       : Window{about_nearest(*task.f, damper.f),
                                                about_nearest(*task.delta, damper.delta)};
  Figure figure = drawn_map(result, window, true, units);
  figure.id = "map";
  figure.title = !result.finding ? shortfall_title(result, units)
                 : task.p.low < task.p.high
                     ? format("The {} at the best period", minimised(task).words)
                     : format("The {} over f and Δ", minimised(task).words);
  if (result.finding) {
    add_box_outline(figure, result.finding->box, units);
  }
  figure.clauses.push_back(beyond_words(task, window, units));
  return figure;
}

/// The box of the design and as much again about it, each damper by itself.
Figure close_up(const design::RecordDesign& result, const FigureUnits& units) {
  const design::SuiteBox& box = result.finding->box;
  const auto about = [](const Interval& range) {
    const double wide = range.high - range.low;
    return Interval{std::max(0.0, range.low - wide / 2), range.high + wide / 2};
  };
  Figure figure = drawn_map(result, {about(box.f), about(box.delta)}, false, units);
  figure.id = "map-near";
  figure.title = "Each damper by itself";
  figure.folded = "Without any error of f and Δ";
  add_box_outline(figure, box, units);
  figure.clauses.emplace_back("the box is what the design may become");
  return figure;
}

}  // namespace

std::vector<Figure> record_maps(const design::RecordDesign& result, const FigureUnits& units) {
  const design::RecordDesignRequest& task = result.request;
  std::vector<Figure> maps;
  if (task.f->low < task.f->high && task.delta->low < task.delta->high) {
    maps.push_back(overview(result, units));
    if (result.finding && result.finding->box.f.low < result.finding->box.f.high &&
        result.finding->box.delta.low < result.finding->box.delta.high) {
      maps.push_back(close_up(result, units));
    }
  }
  return maps;
}

}  // namespace stillpoint::report
