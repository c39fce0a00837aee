// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "damper.hpp"
#include "format.hpp"

#include <stillpoint/design/damper_findings.hpp>
#include <stillpoint/records/decimal.hpp>
#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/report.hpp>

#include <utility>

namespace stillpoint::report {

namespace {

/// The friction of the design, rounded so that it is still feasible: to six digits, or to more
/// where none of six is.
double shown_f(const design::DesignResult& result) {
  constexpr int fewest = 6;
  using enum records::Rounding;
  for (int shown = fewest; shown < digits_of_double; ++shown) {
    for (const records::Rounding rounding : {nearest, up, down}) {
      const double f = records::decimal(result.finding->point.f, shown, rounding);
      if (*result.region.f_lower <= f && f <= *result.region.f_upper) {
        return f;
      }
    }
  }
  return result.finding->point.f;
}

std::string best_part(const DesignReport& report) {
  const design::Limits& limits = report.result.request.limits;
  const design::RatedPart& best = report.catalogue->parts.front();
  return best.tolerance
             ? format("No admissible design: no part has a tolerance of {}; the best, {}, has {}.",
                      tolerance_text(limits, limits.tolerance), best.part.name,
                      tolerance_text(limits, *best.tolerance))
             : "";
}

void add_answer(Section& answer, const DesignReport& report) {
  const design::ShownDamper shown = shown_damper(report.result, report.built_notch);
  const auto& [f, delta, tolerance] = shown.point;
  const design::Limits& limits = report.result.request.limits;
  const Physical& physical = report.physical;
  const bool no_friction = design::wants_no_friction(report.result);
  answer.row("damper",
             format("{}, delta = {}",
                    no_friction ? "f as small as you can make it"
                                : format("f = {}", shown_f(report.result)),
                    length_shown(physical, delta)),
             Tone::heading);
  add_motion(answer, shown, physical);
  answer.row("tolerance",
             no_friction && leaves_any(tolerance)
                 ? format("delta may be off by +-{} with next to no f", percent_digits(tolerance))
                 : tolerance_words(limits, tolerance, delta));
  add_works_for(answer, shown.judged.works_for, task_of(report));
  add_check(answer, report.result.finding->cross_check);
}

}  // namespace

std::string verdict(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  if (!result.finding) {
    const std::string best = report.catalogue ? best_part(report) : "";
    return best.empty() ? none_admissible(result, task_of(report)) : best;
  }
  const design::ShownDamper shown = shown_damper(result, report.built_notch);
  const Physical& physical = report.physical;
  const auto& [f, delta, tolerance] = shown.point;
  const bool weighed = physical && physical->scales.mass_kg;
  const std::string damper =
      report.catalogue
          ? format("part {}: f = {}, delta = {}", report.catalogue->parts.front().part.name,
                   digits(f), length_shown(physical, delta))
          : damper_words(
                physical,
                design::wants_no_friction(result) ? std::nullopt
                                                  : std::optional(weighed ? f : shown_f(result)),
                delta, report.built_notch ? report.built_notch->shape : design::NotchShape());
  const std::string_view does = is_useless(report.findings) ? "The damper found has"
                                : report.catalogue          ? "Order"
                                                            : "Build";
  return format("{} {}: {}.", does, damper, does_words(shown, physical));
}

Document document(const DesignReport& report) {
  const design::DesignResult& result = report.result;
  const auto& found = result.finding;
  const ShownTask task = task_of(report);
  Document document = answered("Damper design", report, found ? Tone::good : Tone::bad);
  if (found) {
    add_answer(document.answer, report);
  } else {
    add_mends(document, result, task);
  }
  if (report.catalogue) {
    add_parts(document, *report.catalogue, task);
  }
  if (found && report.trade_off && !report.trade_off->empty()) {
    add_trade_off(document, *report.trade_off, task);
  }
  if (found) {
    add_constraints(document, found->constraints, report.physical, of_first_swing(task));
  }
  add_findings(document, report.findings, report.physical);
  return document;
}

}  // namespace stillpoint::report
