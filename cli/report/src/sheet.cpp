// SPDX-License-Identifier: MIT
#include "specified.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/report/findings.hpp>

#include <chrono>
#include <cstdlib>

namespace stillpoint::report {

namespace {

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
std::string specified(ShownAnswer answer, const design::ShownDamper& shown,
                      std::string_view of_constraints, const SheetFrame& frame) {
  const auto& [f, delta, tolerance] = shown.point;
  const design::DesignPoint granted = design::granted(shown.point, shown.limits);
  const design::DamperBox box = box_about(granted, shown.limits.shape);
  const double width = answer.design->width;
  ShownCase& only = answer.cases.front();
  only.worst.reset();  // over the box of the answer, not of the sheet
  return body(
      {.answer = answer,
       .of_constraints = of_constraints,
       .damper = {shown.p(), f, delta, width},
       .f = box.f,
       .delta = box.delta,
       .width = {width, width},
       .p = {},
       .tolerance = format("{}: {}", tolerance_words(shown.limits, granted.tolerance, delta),
                           shown.limits.tolerance > 0 ? "what was asked for"
                                                      : "the largest that keeps every limit"),
       .cases = {{only, shown_motion(shown, answer.units), shown.problem.beta,
                  governing_words(design::governing(answer.constraints), answer.units),
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
  return report.result.finding ? std::optional(specified(
                                     shown(report), shown_damper(report.result, report.built_notch),
                                     of_first_swing(task_of(report)), frame))
                               : std::nullopt;
}

std::optional<std::string> sheet(const RegionReport& report, const SheetFrame& frame) {
  const design::RegionAnswer& answer = report.answer;
  return answer.admissible.value_or(false) && answer.response
             ? std::optional(specified(shown(report), shown_damper(report.request, answer),
                                       of_first_swing(task_of(report)), frame))
             : std::nullopt;
}

std::optional<std::string> sheet(const RecordDesignReport& report, const SheetFrame& frame) {
  const design::RecordDesign& result = report.result;
  const auto& finding = result.finding;
  if (!finding || !finding->admissible) {
    return std::nullopt;
  }
  const ShownAnswer answer = shown(report);
  const design::RecordDesignRequest& task = result.request;
  const design::SuiteBox& box = finding->box;
  std::vector<SheetCase> cases;
  for (std::size_t c = 0; c < task.cases.size(); ++c) {
    const design::LoadCase& load_case = task.cases[c];
    const design::CaseMotion motion = motions_of(load_case)[answer.cases[c].duty->index];
    const auto of_case = governing(result, c);
    const design::Constraint* const limit = task.cases.size() == 1
                                                ? design::governing(result.constraints)
                                            : of_case ? &of_case->constraint
                                                      : nullptr;
    cases.push_back({answer.cases[c], scaled_name(motion.name, motion.scale), load_case.limits.peak,
                     governing_words(limit, report.physical),
                     motion_of(task, finding->point.damper, motion)});
  }
  return body(
      {.answer = answer,
       .of_constraints = task.tolerance.exact() ? "" : "Each is the worst within the tolerance.",
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
