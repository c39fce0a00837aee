// SPDX-License-Identifier: MIT
#include <stillpoint/answers/exit_code.hpp>

#include <optional>

namespace stillpoint::answers {

namespace {

template <class Finding>
ExitCode of_design(const std::optional<Finding>& found) {
  return !found ? exit_infeasible : found->cross_check.passed ? exit_done : exit_check_failed;
}

}  // namespace

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
