// SPDX-License-Identifier: MIT
#include "record/suite_front.hpp"

#include "record/suite_request.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace stillpoint::design {

RecordDesign without_errors(const RecordDesignRequest& task) {
  RecordDesign exact;
  exact.request = task;
  exact.request.tolerance = {{}, {}, {}, {}};
  return exact;
}

void find_front(const Suites& suite, RecordDesign& result, SuiteMaps& maps, SuiteWatch& watch) {
  const RecordDesignRequest& task = result.request;
  if (task.trade_offs == 0) {
    return;
  }
  if (task.objective == SuiteObjective::robust && !task.requires_tolerance &&
      !task.tolerance.exact() && std::ranges::none_of(task.cases, &LoadCase::of_records)) {
    RecordDesign exact = without_errors(task);
    SuiteMaps of_exact(suite, exact.request, watch);
    find_front(suite, exact, of_exact, watch);
    result.trade_off = std::move(exact.trade_off);
    return;
  }
  maps.add_missing();
  const auto gentlest = [&](double stroke) {
    SuiteGoal goal{&SuiteFigures::acceleration, {}, limits_of(task)};
    for (SuiteLimits& limits : goal.limits) {
      limits.peak = std::min(limits.peak.value_or(HUGE_VAL), stroke);
    }
    return maps.least(goal);
  };
  const auto end = gentlest(HUGE_VAL);
  const auto begin = maps.least({&SuiteFigures::peak, {}, limits_of(task)});
  if (!begin || !end) {
    return;
  }
  const double low = design::largest(begin->box.worst).peak;
  const double high = design::largest(end->box.worst).peak;
  std::vector<SuitePoint> all{{begin->box.damper, begin->box.worst},
                              {end->box.damper, end->box.worst}};
  const auto last = static_cast<double>(task.trade_offs - 1);
  for (std::int64_t i = 1; i + 1 < task.trade_offs && !watch.stopped(); ++i) {
    if (const auto between = gentlest(std::lerp(low, high, static_cast<double>(i) / last))) {
      all.push_back({between->box.damper, between->box.worst});
    }
  }
  std::ranges::stable_sort(
      all, {}, [](const SuitePoint& point) { return design::largest(point.figures).peak; });
  for (SuitePoint& point : all) {  // no other has less of both
    std::vector<SuitePoint>& front = result.trade_off;
    if (front.empty() || design::largest(point.figures).acceleration <
                             design::largest(front.back().figures).acceleration) {
      front.push_back(std::move(point));
    }
  }
}

}  // namespace stillpoint::design
