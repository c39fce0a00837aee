// SPDX-License-Identifier: MIT
#include <stillpoint/answers/exit_code.hpp>

namespace stillpoint::answers {

ExitCode exit_code(const report::DesignReport& report) {
  if (!report.result.finding) {
    return exit_infeasible;
  }
  return report.result.finding->cross_check.passed ? exit_done : exit_check_failed;
}

ExitCode exit_code(const report::RecordDesignReport& report) {
  if (report.result.search.interrupted) {
    return exit_interrupted;
  }
  if (!report.result.finding) {
    return exit_infeasible;
  }
  return report.result.finding->check.passed ? exit_done : exit_check_failed;
}

ExitCode exit_code(const report::RegionReport& report) {
  return report.answer.region.feasible ? exit_done : exit_infeasible;
}

}  // namespace stillpoint::answers
