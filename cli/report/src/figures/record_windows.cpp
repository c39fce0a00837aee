// SPDX-License-Identifier: MIT
// Which parts of the plane of f and delta the maps of a design under records show.
#include "figures/record_map.hpp"
#include "format.hpp"
#include "record_design_parts.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;

namespace {

/// "No damper: allow a stroke of 62.1 mm": the first limit that would be enough alone.
std::string shortfall_title(const design::RecordDesign& result, const FigureUnits& units) {
  for (const auto& [which, limit, nearest, relaxed] : result.shortfalls) {
    if (relaxed) {
      return which == design::SuiteObjective::acceleration
                 ? format("No damper: allow {:.4g} g to be transmitted", *relaxed)
                 : format("No damper: allow a {} of {}", quantity(which),
                          units.length_words(*relaxed));
    }
  }
  return "No damper meets the limits";
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
  return ends.empty() ? "" : format("; the search went beyond this map, over {}", ends);
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
  const design::SuiteMap all = design::suite_map(task, point.damper.p);
  const ShownValues values = shown_values(all, point.figures, task);
  Interval f{point.damper.f, point.damper.f};
  Interval delta{point.damper.delta, point.damper.delta};
  for (std::size_t i = 0; i < all.figures.size(); ++i) {
    if (admissible(all.figures[i], task.limits) &&
        2 * value_of(all.figures[i], task.objective) <= values.least + values.most) {
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
  Figure figure = drawn_map(result, window, units);
  figure.id = "map";
  figure.title = !result.finding ? shortfall_title(result, units)
                 : task.p.low < task.p.high
                     ? format("The {} at the best period", quantity(task.objective))
                     : format("The {} over f and Δ", quantity(task.objective));
  figure.caption += beyond_words(task, window, units) + ".";
  return figure;
}

/// What the samples of the tolerance are taken from, and as much again about it.
Figure close_up(const design::RecordDesign& result, const FigureUnits& units) {
  const design::Sensitivity& near = result.finding->sensitivity;
  const design::SuiteDamper& damper = result.nearest.damper;
  const auto about = [&](double value, double part) {
    return Interval{std::max(0.0, value * (1 - part)), value * (1 + part)};
  };
  const double wide = 2 * near.tolerance;
  Figure figure = drawn_map(result, {about(damper.f, wide), about(damper.delta, wide)}, units);
  figure.id = "map-near";
  figure.title = format("The same within {:.3g} % of the damper", 100 * wide);
  const Interval f = about(damper.f, near.tolerance);
  const Interval delta = about(damper.delta * units.length, near.tolerance);
  figures::FigureCurve box{format("off by up to {:.3g} %", 100 * near.tolerance),
                           {{{f.low, delta.low},
                             {f.high, delta.low},
                             {f.high, delta.high},
                             {f.low, delta.high},
                             {f.low, delta.low}}},
                           figures::Ink::blue};
  box.hover = false;
  figure.curves.push_back(std::move(box));
  figure.caption += format("; in the box f and Δ are off by up to {:.3g} %.", 100 * near.tolerance);
  return figure;
}

}  // namespace

std::vector<Figure> record_maps(const design::RecordDesign& result, const FigureUnits& units) {
  const design::RecordDesignRequest& task = result.request;
  std::vector<Figure> maps;
  if (task.f->low < task.f->high && task.delta->low < task.delta->high) {
    maps.push_back(overview(result, units));
    const design::SuiteDamper& damper = result.nearest.damper;
    if (result.finding && result.finding->sensitivity.tolerance > 0 && damper.f > 0 &&
        damper.delta > 0) {
      maps.push_back(close_up(result, units));
    }
  }
  return maps;
}

}  // namespace stillpoint::report
