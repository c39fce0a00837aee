// SPDX-License-Identifier: MIT
#include <stillpoint/design/suite_view.hpp>

#include "record/suite.hpp"

#include <stillpoint/design/record_design.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace stillpoint::design {

namespace {

SuiteCell cell_of(const TaskFigures& figures, const RecordDesignRequest& task) {
  const std::vector<SuiteLimits> limits = limits_of(task);
  const SuiteGoal goal{minimised(task).value, task.objective_case, limits};
  SuiteCell cell{goal.value(figures), excess(figures, limits), suite_figure_kinds.size()};
  double most = 0;
  for (std::size_t c = 0; c < figures.size() && settled(figures); ++c) {
    for (std::size_t i = 0; i < suite_figure_kinds.size(); ++i) {
      const auto limit = suite_figure_kinds.at(i).limit;
      SuiteLimits one;
      one.*limit = limits[c].*limit;
      if (const double over = excess(figures[c], one); over > most) {
        most = over;
        cell.fault = i;
      }
    }
  }
  return cell;
}

SuiteView view_of(const RecordDesign& result, const Interval& f, const Interval& delta, bool boxes,
                  std::size_t side = SuiteView().side) {
  RecordDesignRequest task = result.request;
  task.f = f;
  task.delta = delta;
  const SuiteMap map = suite_map(task, result.nearest.damper, boxes, static_cast<int>(side));
  SuiteView view{f, delta, {}, {HUGE_VAL, 0}, side};
  const auto include = [&](const SuiteCell& cell) {
    if (cell.excess == 0) {
      view.values = {std::min(view.values.low, cell.value), std::max(view.values.high, cell.value)};
    }
  };
  include(cell_of(boxes || !result.finding ? result.nearest.figures : result.finding->point.figures,
                  task));
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      view.cells.push_back(cell_of(map.figures[column * side + row], task));
      include(view.cells.back());
    }
  }
  return view;
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

/// The dampers that meet the limits and are nearer to the best value than to the worst, so that a
/// mass that does not move, which meets any limit of the stroke, does not fill the map.
SuiteView good_view(const RecordDesign& result) {
  constexpr std::size_t coarse = 40;
  const SuiteView all = view_of(result, *result.request.f, *result.request.delta, true, coarse);
  const SuiteDamper& damper = result.nearest.damper;
  Interval f{damper.f, damper.f};
  Interval delta{damper.delta, damper.delta};
  const auto include = [](Interval& seen, const Interval& range, std::size_t cell) {
    const double middle =
        range.low + (range.high - range.low) * (static_cast<double>(cell) + 0.5) / coarse;
    seen = {std::min(seen.low, middle), std::max(seen.high, middle)};
  };
  for (std::size_t i = 0; i < all.cells.size(); ++i) {
    const SuiteCell& cell = all.cells[i];
    if (cell.excess == 0 && 2 * cell.value <= all.values.low + all.values.high) {
      include(f, all.f, i % coarse);
      include(delta, all.delta, i / coarse);
    }
  }
  return view_of(result, with_margin(f, all.f), with_margin(delta, all.delta), true);
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

bool is_wide(const Interval& f, const Interval& delta) {
  return f.low < f.high && delta.low < delta.high;
}

}  // namespace

std::vector<double> SuiteView::excesses() const {
  std::set<double> all;
  for (const SuiteCell& now : cells) {
    if (now.excess > 0 && now.fault < suite_figure_kinds.size()) {
      all.insert(now.excess);
    }
  }
  return {all.begin(), all.end()};
}

std::size_t SuiteView::cell(const SuiteDamper& damper) const {
  const auto along = [this](const Interval& range, double value) {
    const double place = (value - range.low) / (range.high - range.low) * static_cast<double>(side);
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(side - 1)));
  };
  return along(delta, damper.delta) * side + along(f, damper.f);
}

std::optional<SuiteView> overview(const RecordDesign& result) {
  const Interval& f = *result.request.f;
  const Interval& delta = *result.request.delta;
  const SuiteDamper& damper = result.nearest.damper;
  return !is_wide(f, delta) ? std::nullopt
         : result.finding   ? std::optional(good_view(result))
                            : std::optional(view_of(result, about_nearest(f, damper.f),
                                                    about_nearest(delta, damper.delta), true));
}

std::optional<SuiteView> close_up(const RecordDesign& result) {
  const auto about = [](const Interval& range) {
    const double wide = range.high - range.low;
    return Interval{std::max(0.0, range.low - wide / 2), range.high + wide / 2};
  };
  return result.finding && is_wide(*result.request.f, *result.request.delta) &&
                 is_wide(result.finding->box.f, result.finding->box.delta)
             ? std::optional(view_of(result, about(result.finding->box.f),
                                     about(result.finding->box.delta), false))
             : std::nullopt;
}

Spectrum spectrum_about(const RecordDesign& result, std::size_t in_case) {
  constexpr int points = 141;
  constexpr double shortest = 0.25;
  constexpr double longest = 2;
  const RecordDesignRequest& task = result.request;
  const SuiteDamper& damper = result.finding->point.damper;
  SpectrumRequest request{task.cases[in_case], {}, oscillator_of(task, damper), {}, task.threads};
  if (damper.delta > 0) {
    request.notch_width = damper.notch_width();
  }
  for (int i = 0; i < points; ++i) {
    request.p.push_back(damper.p /
                        std::lerp(shortest, longest, static_cast<double>(i) / (points - 1)));
  }
  return spectrum(request);
}

}  // namespace stillpoint::design
