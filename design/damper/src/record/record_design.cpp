// SPDX-License-Identifier: MIT
#include <stillpoint/design/record_design.hpp>

#include "record/suite.hpp"
#include "record/suite_check.hpp"
#include "record/suite_digits.hpp"
#include "record/suite_request.hpp"
#include "record/suite_search.hpp"
#include "record/suite_sensitivity.hpp"
#include "record/suite_watch.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/seconds.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace stillpoint::design {

namespace {

/// A limit alone that was relaxed is this much above the least that was found, so that a search
/// with it, which is no more accurate than that, finds a damper as well.
constexpr double relaxed_by = 1e-3;

/// What each limit would have to be, with the others unchanged.
std::vector<SuiteShortfall> shortfalls(const Suite& suite, const SuiteBox& box,
                                       const SuiteScan& scan, const RecordDesignRequest& request,
                                       const SuiteFigures& nearest, std::int64_t& evaluations,
                                       SuiteWatch& watch) {
  watch.expect(usual_evaluations(box) *
               std::ranges::count_if(suite_figure_kinds, [&](const auto& kind) {
                 return (request.limits.*kind.limit).has_value();
               }));
  std::vector<SuiteShortfall> list;
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    SuiteLimits limits = request.limits;
    const std::optional<double> limit = std::exchange(limits.*kind.limit, std::nullopt);
    if (!limit) {
      continue;
    }
    const SuiteOptimum least =
        optimum(suite, box, scan, kind.objective, limits, request.threads, watch);
    evaluations += least.evaluations;
    SuiteShortfall shortfall{kind.objective, *limit, nearest.*kind.value, {}};
    if (!watch.stopped() && admissible(least.point.figures, limits)) {
      shortfall.relaxed = least.point.figures.*kind.value * (1 + relaxed_by);
    }
    list.push_back(shortfall);
  }
  return list;
}

}  // namespace

RecordDesign design(const RecordDesignRequest& request, const RecordWatch& go_on) {
  require_valid(request);
  const double begun = seconds_now();
  RecordDesign result{completed(request), {}, {}, {}, {}};
  const RecordDesignRequest& task = result.request;
  const Suite suite(task);
  const SuiteBox box(task);
  SuiteWatch watch(task, go_on);
  const auto [side, all] = grid_size(box, task.scan_points);
  watch.expect(all + usual_evaluations(box));
  SuiteScan scan{side, grid_figures(suite, box, side, all, task.threads, watch)};
  const auto evaluated = std::ssize(scan.figures);
  SuiteFigures unknown;
  unknown.settled = false;
  scan.figures.resize(static_cast<std::size_t>(all), unknown);
  SuiteOptimum found = optimum(suite, box, scan, task.objective, task.limits, task.threads, watch);
  result.search = {found.algorithm,
                   found.status,
                   found.evaluations,
                   0,
                   evaluated,
                   std::ranges::count_if(scan.figures,
                                         [&](const SuiteFigures& figures) {
                                           return admissible(figures, task.limits);
                                         }),
                   false};
  const SuitePoint point = with_few_digits(suite, task, found.point);
  result.nearest = point;
  const bool feasible = admissible(point.figures, task.limits);
  if (!feasible) {
    result.shortfalls =
        shortfalls(suite, box, scan, task, point.figures, result.search.evaluations, watch);
  }
  result.search.interrupted = watch.stopped();
  result.search.wall_time_s = seconds_now() - begun;
  if (feasible) {
    RecordFinding finding{point, suite.responses(point.damper), {}, {}};
    finding.sensitivity = sensitivity(suite, task, point);
    finding.check = check(suite, point.damper, finding.responses);
    result.finding = std::move(finding);
  }
  return result;
}

SuiteFigures figures_of(const RecordDesignRequest& request, const SuiteDamper& damper) {
  return Suite(request).figures(damper);
}

SuiteMap suite_map(const RecordDesignRequest& request, double p, int side) {
  require_valid(request);
  require_within("side", side, 1, 10'000);
  const RecordDesignRequest task = completed(request);
  const Suite suite(task);
  SuiteMap map;
  const auto middle = [side](const Interval& range, int i) {
    return range.low + (range.high - range.low) * (i + 0.5) / side;
  };
  for (int i = 0; i < side; ++i) {
    map.f.push_back(middle(*task.f, i));
    map.delta.push_back(middle(*task.delta, i));
  }
  const auto cells = static_cast<std::size_t>(side);
  std::vector<SuiteDamper> dampers;
  dampers.reserve(cells * cells);
  for (const double f : map.f) {
    for (const double delta : map.delta) {
      dampers.push_back({p, f, delta});
    }
  }
  map.figures = suite.figures(dampers, task.threads);
  return map;
}

std::string summary(const RecordDesign& result) {
  const auto& [damper, figures] = result.finding ? result.finding->point : result.nearest;
  const std::string point =
      fmt::format("p = {:.6g}, f = {:.6g}, delta = {:.6g}", damper.p, damper.f, damper.delta);
  const std::string does =
      figures.settled
          ? fmt::format("transmits {:.4g} g, moves up to |x| = {:.4g} and rests within {:.4g}",
                        figures.acceleration, figures.peak, figures.residual)
          : "does not come to rest";
  return result.finding ? fmt::format("{} {}{}", point, does,
                                      result.finding->check.passed ? "" : "; the check failed")
                        : fmt::format("no damper: the nearest, {}, {}", point, does);
}

}  // namespace stillpoint::design
