// SPDX-License-Identifier: MIT
#include <stillpoint/answers/hit.hpp>

#include <stillpoint/design/damper_findings.hpp>

#include <utility>

namespace stillpoint::answers {

report::DesignReport answer(DesignTask task) {
  const design::DesignRequest& request = task.request;
  report::DesignReport report;
  report.physical = task.physical;
  if (task.catalogue) {
    design::Choice choice = design::choose(request, task.catalogue->parts);
    report.result = std::move(choice.result);
    report.catalogue = {std::move(task.catalogue->file), std::move(choice.parts)};
  } else {
    report.result = design::design(request);
  }
  report.trade_offs = task.trade_offs;
  if (task.trade_offs) {
    report.trade_off = design::trade_off(request.problem, request.limits, *task.trade_offs);
  }
  if (report.result.finding && task.notch) {
    report.built_notch = design::built_notch(report.result, *task.notch);
  }
  report.findings =
      design::findings_of(report.result, report.built_notch,
                          {report.physical.has_value(), report.catalogue.has_value()});
  return report;
}

report::RegionReport answer(RegionTask task) {
  const auto& [problem, limits, f, delta, pulse, ranges] = task.request;
  report::RegionReport report{task.request, design::answer(task.request), task.physical};
  if (task.catalogue) {
    const std::vector<design::Part>& parts = task.catalogue->parts;
    report.catalogue = {std::move(task.catalogue->file),
                        pulse ? design::choose({problem, limits, {}, pulse, ranges}, parts).parts
                              : design::ranked(problem, limits, design::Objective::robust, parts)};
  }
  report.findings =
      design::findings_of(report.request, report.answer, {report.physical.has_value()});
  return report;
}

}  // namespace stillpoint::answers
