// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <stillpoint/design/design.hpp>
#include <stillpoint/design/record_design.hpp>
#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <utility>

namespace stillpoint::cli {

/// The exit codes, fixed for scripts.
enum ExitCode : int {
  exit_done = 0,
  exit_wrong_input = 2,
  exit_infeasible = 3,
  exit_check_failed = 4,
  exit_interrupted = 130,  ///< the shells' code for SIGINT
};

/// 3 without an admissible design, 4 where the cross-check failed, else 0.
[[nodiscard]] ExitCode exit_code(const design::DesignResult& result);
[[nodiscard]] ExitCode exit_code(const design::RecordDesign& result);
[[nodiscard]] inline ExitCode exit_code(const report::DesignReport& report) {
  return exit_code(report.result);
}
[[nodiscard]] inline ExitCode exit_code(const report::RecordDesignReport& report) {
  return exit_code(report.result);
}
[[nodiscard]] inline ExitCode exit_code(const report::RegionReport& report) {
  return report.answer.region.feasible ? exit_done : exit_infeasible;
}
[[nodiscard]] inline ExitCode exit_code(const report::MotionReport& /*report*/) {
  return exit_done;
}
[[nodiscard]] inline ExitCode exit_code(const report::SpectrumReport& /*report*/) {
  return exit_done;
}

/// What design and region have to say, before anything is shown; of a design for a hit, see
/// designs_under_records.
[[nodiscard]] report::DesignReport design_report(const Settings& settings);
[[nodiscard]] report::RegionReport region_report(const Settings& settings);

/// What a command found, for whoever is not the program. Its report is made when someone looks.
class Answer {
 public:
  Answer() = default;
  Answer(const Answer&) = delete;
  Answer& operator=(const Answer&) = delete;
  Answer(Answer&&) = delete;
  Answer& operator=(Answer&&) = delete;
  virtual ~Answer() = default;

  [[nodiscard]] virtual ExitCode exit() const = 0;
  [[nodiscard]] virtual nlohmann::ordered_json json() const = 0;
  [[nodiscard]] virtual report::Document document() const = 0;
  [[nodiscard]] virtual figures::HtmlPage page() const = 0;
};

/// Of a report that has json(), document() and page().
template <class Report>
class AnswerOf : public Answer {
 public:
  explicit AnswerOf(Report report) : report_(std::move(report)) {}

  [[nodiscard]] ExitCode exit() const override { return exit_code(report_); }
  [[nodiscard]] nlohmann::ordered_json json() const override { return report::json(report_); }
  [[nodiscard]] report::Document document() const override { return report::document(report_); }
  [[nodiscard]] figures::HtmlPage page() const override { return report::page(report_); }

  [[nodiscard]] const Report& made() const { return report_; }

 private:
  Report report_;
};

template <class Report>
[[nodiscard]] std::unique_ptr<Answer> answer_of(Report report) {
  return std::make_unique<AnswerOf<Report>>(std::move(report));
}

using GoOn = std::function<bool()>;

/// The motion of simulate, with a trajectory if samples or an end were asked for.
[[nodiscard]] report::MotionReport motion_report(const Settings& settings, const GoOn& go_on);

/// design, region, simulate or spectrum. `go_on` is asked now and then; false ends the run with
/// what there is. Throws InputError, UsageError and FileError.
[[nodiscard]] std::unique_ptr<Answer> answer(Command command, const Settings& settings,
                                             const GoOn& go_on);

}  // namespace stillpoint::cli
