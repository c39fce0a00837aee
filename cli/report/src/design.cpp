// SPDX-License-Identifier: MIT
#include "choices.hpp"

#include <stillpoint/design/damper_findings.hpp>
#include <stillpoint/report/findings.hpp>

namespace stillpoint::report {

namespace {

void add_answer(Section& answer, const DesignReport& report) {
  const design::ShownDamper shown = shown_damper(report.result, report.built_notch);
  const double tolerance = shown.point.tolerance;
  const auto f = design::told_f(report.result);
  answer.row("damper",
             format("{}, delta = {}", f ? format("f = {}", *f) : "f as small as you can make it",
                    length_shown(report.physical, shown.point.delta)),
             Tone::heading);
  add_motion(answer, shown, report.physical);
  answer.row("tolerance",
             !f && leaves_any(tolerance)
                 ? format("delta may be off by +-{} with next to no f", percent_digits(tolerance))
                 : tolerance_words(shown.limits, tolerance, shown.point.delta));
  if (f) {
    add_buildable(answer, report.physical, shown.point, shown.limits);
  }
  add_works_for(answer, shown.judged.works_for, report.physical);
  add_check(answer, report.result.finding->cross_check);
}

}  // namespace

std::string verdict(const DesignReport& report) {
  if (!report.result.finding) {
    return none_admissible(report.result, task_of(report));
  }
  const design::ShownDamper shown = shown_damper(report.result, report.built_notch);
  const auto& catalogue = report.catalogue;
  const bool sound = leaves_any(shown.point.tolerance) && advice(report.findings, "").empty();
  return format(
      "{} {}: {}.",
      sound       ? (catalogue ? "Order" : "Build")
      : catalogue ? "The damper found is"
                  : "The damper found has",
      (catalogue ? format("part {}, ", catalogue->parts.front().part.name) : "") +
          damper_words(report.physical, design::told_f(report.result), shown.point.delta,
                       shown.built != nullptr ? shown.built->shape : design::NotchShape()),
      does_words(shown, report.physical));
}

Document document(const DesignReport& report) {
  const auto& found = report.result.finding;
  const ShownTask task = task_of(report);
  Document document = answered("Damper design", report, found ? Tone::good : Tone::bad);
  if (found) {
    add_answer(document.answer, report);
  } else {
    add_mends(document, report.result, task);
  }
  if (report.catalogue) {
    add_parts(document, report.catalogue->parts, report.physical, task.limits);
  }
  if (found) {
    add_trade_off(document, front_of(report), report.physical, task.limits);
    add_constraints(document, found->constraints, report.physical, of_first_swing(task));
  }
  add_findings(document, report.findings, report.physical);
  return document;
}

}  // namespace stillpoint::report
