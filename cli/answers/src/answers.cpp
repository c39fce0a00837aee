// SPDX-License-Identifier: MIT
#include <stillpoint/answers/answers.hpp>

#include <stillpoint/design/damper_findings.hpp>

#include <utility>

namespace stillpoint::answers {

namespace {

template <class Finding>
ExitCode of_design(const std::optional<Finding>& found) {
  return !found ? exit_infeasible : found->cross_check.passed ? exit_done : exit_check_failed;
}

}  // namespace

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

ExitCode exit_code(const report::DesignReport& report) {
  return of_design(report.result.finding);
}

ExitCode exit_code(const report::RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  return result.region               ? result.region->f.empty() ? exit_infeasible : exit_done
         : result.search.interrupted ? exit_interrupted
         : report.of_region && !result.finding ? exit_done
                                               : of_design(result.finding);
}

ExitCode exit_code(const report::RegionReport& report) {
  return report.answer.region.feasible ? exit_done : exit_infeasible;
}

}  // namespace stillpoint::answers
