// SPDX-License-Identifier: MIT
#include "specified.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/report/findings.hpp>

#include <chrono>
#include <cstdlib>

namespace stillpoint::report {

namespace {

using design::Duty;

/// "12 % of the limit is left"
std::string governing_words(const design::Constraint* limit, const Physical& physical) {
  if (limit == nullptr) {
    return "nothing";
  }
  const auto& motion = limit->motion;
  return format("{}{}, {} left{}", requirement(*limit, units_of(physical)),
                limit->variable == "f" ? force_beside(physical, limit->limit) : "",
                part_words(part_left(*limit)),
                motion ? " under " + scaled_name(motion->file, motion->scale) : "");
}

/// Of hits and pulses.
std::string specified(const design::ShownDamper& shown, const Physical& physical,
                      std::string verdict, std::span<const design::Finding> findings,
                      const design::CrossCheck* check, const ShownTask& task,
                      const SheetFrame& frame) {
  const design::DesignPoint& point = shown.point;
  const design::DesignPoint granted = design::granted(point, shown.limits);
  const design::DamperBox box = box_about(granted, shown.limits.shape);
  const double width = shown.built != nullptr ? shown.built->shape.width.value_or(0) : 0;
  const bool asked = shown.limits.tolerance > 0;
  const design::Judged& judged = shown.judged;
  const auto& practice = judged.practice_worst ? judged.practice_worst : judged.practice;
  return body(
      {.physical = physical,
       .verdict = std::move(verdict),
       .findings = findings,
       .constraints = judged.constraints,
       .of_constraints = of_first_swing(task),
       .check = check,
       .works_for = judged.works_for,
       .practice = practice ? &*practice : nullptr,
       .damper = {shown.p(), point.f, point.delta, width},
       .f = box.f,
       .delta = box.delta,
       .width = {width, width},
       .p = {},
       .tolerance = format("{}: {}", tolerance_words(shown.limits, granted.tolerance, point.delta),
                           asked ? "what was asked for" : "the largest that keeps every limit"),
       .cases = {{{},
                  shown_motion(shown, physical),
                  duty_of(shown),
                  shown.problem.beta,
                  {},
                  governing_words(design::governing(judged.constraints), physical),
                  motion_of(shown)}}},
      frame);
}

}  // namespace

std::string sheet_date() {
  namespace chrono = std::chrono;
  auto now = chrono::floor<chrono::seconds>(chrono::system_clock::now()).time_since_epoch();
  if (const char* const fixed = std::getenv("SOURCE_DATE_EPOCH"); fixed != nullptr) {
    now = chrono::seconds(records::parse_integer("SOURCE_DATE_EPOCH", fixed));
  }
  const chrono::year_month_day date(chrono::sys_days(chrono::floor<chrono::days>(now)));
  return format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::optional<std::string> sheet(const DesignReport& report, const SheetFrame& frame) {
  const auto& found = report.result.finding;
  return found ? std::optional(specified(shown_damper(report.result, report.built_notch),
                                         report.physical, verdict(report), report.findings,
                                         &found->cross_check, task_of(report), frame))
               : std::nullopt;
}

std::optional<std::string> sheet(const RegionReport& report, const SheetFrame& frame) {
  const design::RegionAnswer& answer = report.answer;
  return answer.admissible.value_or(false) && answer.response
             ? std::optional(specified(shown_damper(report.request, answer), report.physical,
                                       verdict(report), report.findings, nullptr, task_of(report),
                                       frame))
             : std::nullopt;
}

std::optional<std::string> sheet(const RecordDesignReport& report, const SheetFrame& frame) {
  const design::RecordDesign& result = report.result;
  const auto& finding = result.finding;
  if (!finding || !finding->admissible) {
    return std::nullopt;
  }
  const design::RecordDesignRequest& task = result.request;
  const design::SuiteBox& box = finding->box;
  const std::vector<Duty> duties = duties_of(result);
  std::vector<SheetCase> cases;
  for (std::size_t c = 0; c < task.cases.size(); ++c) {
    const design::LoadCase& load_case = task.cases[c];
    const design::CaseMotion motion = motions_of(load_case)[duties[c].index];
    const auto limit = governing(result, c);
    cases.push_back({load_case.name, scaled_name(motion.name, motion.scale), duties[c],
                     load_case.limits.peak, box.worst[c],
                     governing_words(limit ? &limit->constraint : nullptr, report.physical),
                     motion_of(task, finding->point.damper, motion)});
  }
  return body(
      {.physical = report.physical,
       .verdict = verdict(report),
       .findings = result.findings,
       .constraints = result.constraints,
       .of_constraints = task.tolerance.exact() ? "" : "Each is the worst within the tolerance.",
       .check = &finding->cross_check,
       .works_for = finding->works_for,
       .practice = nullptr,
       .damper = finding->point.damper,
       .f = box.f,
       .delta = box.delta,
       .width = box.width,
       .p = box.p,
       .tolerance = box.samples > 1 ? box_words(box, true)
                    : result.largest_tolerance
                        ? format("none was asked for; the largest that was found is {}",
                                 percent_digits(*result.largest_tolerance))
                        : "none was asked for",
       .cases = std::move(cases)},
      frame);
}

}  // namespace stillpoint::report
