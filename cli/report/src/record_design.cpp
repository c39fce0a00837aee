// SPDX-License-Identifier: MIT
#include <stillpoint/report/record_design.hpp>
#include "choices.hpp"

#include <stillpoint/report/findings.hpp>

#include <array>
#include <numbers>

namespace stillpoint::report {

namespace {

constexpr int printed_digits = 12;  // of a design: as many as it was rounded to, or almost all

/// In which a period is printed; the usual ones unless it was searched.
std::optional<int> period_digits(const design::RecordDesignRequest& task) {
  return task.p.low < task.p.high ? std::optional(printed_digits) : std::nullopt;
}

/// "0.1991 g transmitted, stroke 307.18 mm, residual 35.709 mm"
std::string figures_words(const design::SuiteFigures& figures, const Physical& physical) {
  return acceleration_shown(figures.acceleration) + " transmitted" +
         (figures.peak == 0 ? ""
                            : format(", stroke {}, residual {}",
                                     figure_shown(physical, Dimension::length, figures.peak),
                                     figure_shown(physical, Dimension::length, figures.residual)));
}

/// "Largest of 3 cases"
std::string whose_words(const std::vector<design::LoadCase>& cases) {
  const design::LoadCase& first = cases.front();
  return cases.size() > 1
             ? format("Largest of {} cases", cases.size())
             : design::suite_words(first) + (first.weakest < 1 ? "s of the range" : "");
}

/// ", worst within a tolerance of 10 %" of the dampers of a box, ", at worst" of ranges alone;
/// empty of a single motion.
std::string worst_words(const design::RecordDesign& result) {
  const auto& [f, delta, width, period] = result.request.tolerance;
  if (result.finding->box.samples <= 1) {
    return "";
  }
  const bool alike = f.below == f.above && f.below == delta.below && f.below == delta.above &&
                     period.below + period.above == 0;
  const double part = result.request.judges ? f.below : result.largest_tolerance.value_or(f.below);
  return result.request.tolerance.exact() ? ", at worst"
         : alike ? format(", worst within a tolerance of {:.3g} %", 100 * part)
                 : ", worst within the tolerance";
}

/// "with a period of 2.8 s", or of a spring that varies "for periods of 2.4 to 3 s".
std::string sprung_words(const design::RecordDesign& result, const Physical& physical) {
  const double p = result.finding->point.damper.p;
  const auto& [below, above] = result.request.spring;
  if (below + above == 0) {
    return "with " + period_words(physical, p, period_digits(result.request));
  }
  const double period = 2 * std::numbers::pi / p * units_of(physical).time;
  return physical ? format("for periods of {:.4g} to {:.4g} s", period * (1 - below),
                           period * (1 + above))
                  : format("for p of {:.6g} to {:.6g}", p / (1 + above), p / (1 - below));
}

/// With the digits with which the figures of a design come true.
std::string exact_words(const Physical& physical, const design::SuiteDamper& damper,
                        std::optional<int> digits) {
  return format(
      "f = {:.{}g}, delta = {}{}", damper.f, digits.value_or(6),
      length_shown(physical, damper.delta, digits),
      damper.width > 0 ? format(", {} wide", length_shown(physical, damper.width, digits)) : "");
}

void add_answer(Section& answer, const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const Physical& physical = report.physical;
  const design::SuitePoint& point = result.finding->point;
  answer.row("damper",
             exact_words(physical, point.damper, printed_digits) +
                 (result.request.judges ? force_beside(physical, point.damper.f) : ""),
             Tone::heading);
  if (const auto digits = period_digits(result.request)) {
    const Interval& searched = result.request.p;
    constexpr double apart = 1e-6;
    const bool at_end = point.damper.p <= searched.low * (1 + apart) ||
                        point.damper.p >= searched.high * (1 - apart);
    answer.row("spring", spring_words(physical, point.damper.p, digits) +
                             (at_end ? ", an end of what was searched" : ""));
  }
  add_damping(answer, oscillator_of(result.request, point.damper), result.request.zeta.high);
  if (result.largest_tolerance && !result.request.judges) {
    answer.row("tolerance",
               format("{:.3g} %, the largest that was found", 100 * *result.largest_tolerance));
  }
  if (result.finding->box.samples > 1) {
    answer.row(result.finding->box.exact ? "proved" : "tried",
               box_words(result.finding->box, result.finding->admissible));
    if (result.finding->admissible) {
      add_buildable(answer, physical, result.finding->box.f, result.finding->box.delta);
    }
    answer.row("exact", "without any error: " + figures_words(largest(point.figures), physical));
  }
  add_works_for(answer, result.finding->works_for, physical);
  add_check(answer, result.finding->cross_check);
}

/// ": f and delta may both be off by +-12 %, and so may the width"; nothing where that is not
/// known.
std::string off_words(const design::RecordDesign& result) {
  if (!result.largest_tolerance) {
    return "";
  }
  const double largest = *result.largest_tolerance;
  const design::SuiteDamper& damper = result.finding->point.damper;
  const auto& [f, delta, width, period] = result.request.tolerance;
  const double most = std::max({f.below, f.above, delta.below, delta.above});
  design::Limits limits;
  if (most > 0) {
    limits.shape = {f.below / most, f.above / most, delta.below / most, delta.above / most};
  }
  const bool wide = damper.width > 0 && width.below + width.above > 0 && leaves_any(largest) &&
                    limits.shape == design::BoxShape{};
  return format(": {}{}", tolerance_words(limits, largest, damper.delta),
                wide ? ", and so may the width" : "");
}

/// What the given damper lacks, or may be off by.
std::string judgement(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  if (!result.finding) {
    const design::RecordDesignRequest& task = result.request;
    const bool slows = task.f->high > 0 || task.delta->high > 0;
    return format("The damper is not admissible: {}the mass {}.",
                  task.tolerance.exact() || !slows ? "" : "with a damper of its tolerance ",
                  slows ? "moves too long before it rests" : "never comes to rest");
  }
  if (!result.finding->admissible) {
    return format("The damper is not admissible{}: {}.",
                  result.largest_tolerance ? " with this tolerance" : "",
                  broken(result.constraints, report.physical));
  }
  return format("The damper is admissible{}. {}{}: {}.", off_words(result),
                whose_words(result.request.cases), worst_words(result),
                figures_words(largest(result.finding->box.worst), report.physical));
}

/// The worst of each case within the tolerance, and what governs it, under which motion and damper
/// of the box.
void add_cases(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const std::vector<design::LoadCase>& cases = result.request.cases;
  const FigureUnits units = units_of(physical);
  const auto number = [](double value) { return format("{:.4g}", value); };
  Table worst{{"case", in("stroke", units.length), in("residual", units.length), "transmitted, g",
               "governed by", "slack"},
              {}};
  Table governs{{"case", "under", "f", in("delta", units.length), "damping, %"}, {}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const design::SuiteFigures& figures = result.finding->box.worst[i];
    const auto now = design::governing(result, i);
    const bool rests_at_0 = begins_at_nothing(figures.residual, figures.peak);
    worst.rows.push_back(
        {{cases[i].name, number(figures.peak * units.length),
          number(rests_at_0 ? 0 : figures.residual * units.length), number(figures.acceleration),
          now ? requirement(now->constraint, units) : "nothing",
          now ? part_words(now->part_left) : ""},
         !now                        ? Tone::plain
         : now->constraint.satisfied ? Tone::good
                                     : Tone::bad});
    if (now) {
      const auto& motion = now->constraint.motion;
      const double zeta = oscillator_of(result.request, now->damper).zeta;
      governs.rows.push_back(
          {{cases[i].name, scaled_name(motion->file, motion->scale), number(now->damper.f),
            number(now->damper.delta * units.length), zeta > 0 ? number(100 * zeta) : ""}});
    }
  }
  document.section("Cases", {std::move(worst)});
  document.section("What governs", {without_empty_columns(std::move(governs))}).detail = true;
}

void add_motions(Document& document, const design::RecordDesign& result, const Physical& physical) {
  const FigureUnits units = units_of(physical);
  const auto number = [](double value) { return format("{:.5g}", value); };
  const std::vector<design::LoadCase>& cases = result.request.cases;
  const bool alone = cases.size() == 1;
  const bool shaken = alone && cases.front().of_records();
  Table table{{"case", shaken ? "record" : "motion", "PGA, g", in("peak", units.length),
               in("residual", units.length), "transmitted, g", in("rests from", units.time), ""},
              {}};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const std::vector<design::CaseMotion> motions = design::motions_of(cases[c]);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      const ForcedResponse& response = result.finding->responses[c][i];
      const auto figures = design::suite_figures(response);
      const bool rests_at_0 = begins_at_nothing(figures.residual, figures.peak);
      table.rows.push_back(
          {{i == 0 ? cases[c].name : "", scaled_name(motions[i].name, motions[i].scale),
            cases[c].v0 ? "" : number(design::peak_load(motions[i].load)),
            number(figures.peak * units.length),
            number(rests_at_0 ? 0 : figures.residual * units.length), number(figures.acceleration),
            alone ? number(*response.stop_time * units.time) : "",
            response.locks() && alone ? "locked" : ""}});
    }
  }
  document.section(shaken ? "Records" : "Motions", {without_empty_columns(std::move(table))})
      .detail = !alone;
}

/// A mend of its length is one of a task with that pulse alone.
const std::optional<design::Pulse>& pulse_of(const design::RecordDesign& result) {
  return result.request.cases.front().pulse;
}

std::string no_damper(const design::RecordDesign& result, const Physical& physical) {
  const auto& largest = result.largest_tolerance;
  const auto way_out = [&] { return one_way_out(result.mends, physical, {}, pulse_of(result)); };
  return result.search.interrupted ? "No damper was verified before the search was interrupted."
         : !result.nearest.figures.empty() && !settled(result.nearest.figures)
             ? "No damper was found: none of those tried comes to rest."
         : !result.constraints.empty() &&
                 std::ranges::all_of(result.constraints, &design::Constraint::satisfied)
             ? "No damper was found that meets the limits by more than rounding." + way_out()
             : format("No damper was found that meets the limits{}{}.{}{}",
                      result.request.tolerance.exact() ? "" : " within its tolerance",
                      result.mends.empty() && !largest && !result.constraints.empty()
                          ? ", nor with any one of them relaxed"
                          : "",
                      largest ? format(" The largest tolerance within the limits is {:.2g} %.",
                                       100 * *largest)
                              : "",
                      way_out());
}

/// Without the end of what is looked at.
Interval unbounded(const design::RecordDesign& result, const Interval& delta) {
  return {delta.low, delta.high < result.request.delta->high ? delta.high : HUGE_VAL};
}

/// "Feasible f: 0.0043 or 0.0106 to 0.0236."; of a given f which delta is.
std::string region_words(const design::RecordDesign& result, const Physical& physical) {
  const std::string_view asked =
      result.request.tolerance.exact() ? "" : " with the tolerance asked for";
  const auto& [feasible_f, deltas] = *result.region;
  if (feasible_f.empty()) {
    return no_damper(result, {});
  }
  const Interval& f = *result.request.f;
  if (f.low < f.high) {
    return format("Feasible f{}: {}.", asked, feasible_words(feasible_f));
  }
  std::vector<Interval> all;
  all.reserve(deltas.size());
  for (const auto& [each, delta] : deltas) {
    all.push_back(unbounded(result, delta));
  }
  return format("Feasible delta at f = {:.{}g}{}: {}.", f.low, digits_of_region, asked,
                delta_words(all, physical));
}

/// Which delta each f may have.
Document region_document(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  Document document =
      answered("Admissible region", report, result.region->f.empty() ? Tone::bad : Tone::good);
  add_damping(document.answer, oscillator_of(result.request, {}), result.request.zeta.high);
  if (result.region->f.empty()) {
    document.answer.row("way out", "design says what would make it feasible");
    return document;
  }
  Table table{{"f", "feasible delta"}, {}};
  constexpr std::size_t every = 5;  // of the f
  std::size_t values = 0;
  double last = -1;
  for (const auto& [f, delta] : result.region->deltas) {
    values += f == std::exchange(last, f) ? 0U : 1U;
    if (values % every != 1) {
      continue;
    }
    table.rows.push_back({{format("{:.{}g}", f, digits_of_region),
                           delta_words(std::array{unbounded(result, delta)}, report.physical)}});
  }
  document.section("Feasible dampers", {std::move(table)});
  return document;
}

}  // namespace

std::string part_words(double part) {
  constexpr double whole = 0.1;
  return std::abs(part) < whole ? format("{:.2g} %", 100 * part) : format("{:.0f} %", 100 * part);
}

std::string scaled_name(std::string_view file, double scale) {
  return (scale == 1 ? "" : format("{:.4g} x ", scale)) +
         spelled_out(file.substr(file.rfind('/') + 1));
}

std::string record_words(std::string_view file, double scale, std::string_view units, bool assumed,
                         double peak) {
  return format("{}, in {}{}, peak {}", scaled_name(file, scale), units,
                assumed ? " (assumed)" : "", acceleration_shown(peak));
}

std::string progress_words(const design::RecordProgress& progress, const Physical& physical) {
  const std::string words = format("{} of about {} dampers", progress.evaluations,
                                   std::max(progress.expected, progress.evaluations));
  return progress.best ? format("{}, best verified {}", words,
                                figures_words(largest(progress.best->figures), physical))
                       : words;
}

std::string verdict(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const Physical& physical = report.physical;
  const auto& parts = result.request.parts;
  if (result.request.judges && parts.empty()) {
    return judgement(report);
  }
  if (result.region) {
    return region_words(result, physical);
  }
  if (!result.finding) {
    return parts.empty() ? no_damper(result, physical)
                         : format("{}.", parts.size() == 1
                                             ? "The only part of the catalogue is not admissible"
                                             : format("None of the {} parts of the catalogue is "
                                                      "admissible",
                                                      parts.size()));
  }
  const design::SuiteDamper& damper = result.finding->point.damper;
  return format("{} {}, {}. {}{}: {}.",
                result.search.interrupted ? "The best damper so far has"
                : parts.empty()           ? advice(result.findings)
                : advice(result.findings, "").empty()
                    ? format("Order part {},", result.finding->part)
                    : format("The best part, {}, has", result.finding->part),
                damper_words(physical, damper.f, damper.delta,
                             {damper.notch_width(), result.request.hold}, printed_digits),
                sprung_words(result, physical), whose_words(result.request.cases),
                worst_words(result), figures_words(largest(result.finding->box.worst), physical));
}

Document document(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const Physical& physical = report.physical;
  const bool good = result.finding && result.finding->admissible;
  if (result.region) {
    return region_document(report);
  }
  Document document = answered(!report.of_region           ? "Damper design"
                               : report.parts_file.empty() ? "Given damper"
                                                           : "Given parts",
                               report, good ? Tone::good : Tone::bad);
  if (result.finding) {
    add_answer(document.answer, report);
    if (result.request.cases.size() > 1) {
      add_cases(document, result, physical);
    }
    add_trade_off(document, front_of(result), physical);
    add_motions(document, result, physical);
  } else if (settled(result.nearest.figures)) {
    const design::SuiteDamper& damper = result.nearest.damper;
    document.answer.row("nearest", format("{}, with {}", exact_words(physical, damper, {}),
                                          spring_words(physical, damper.p)));
    if (!result.mends.empty()) {
      add_mends(document, result.mends, physical, {}, pulse_of(result));
    }
  }
  if (!result.parts.empty()) {
    add_parts(document, result.parts, physical);
  }
  add_constraints(
      document, result.constraints, physical,
      result.request.tolerance.exact() ? "" : "Each is the worst within the tolerance.");
  add_findings(document, result.findings, physical);
  return document;
}

}  // namespace stillpoint::report
