// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "damper.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/findings.hpp>
#include <stillpoint/report/report.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

constexpr int digits_of_f = 6;

/// "up to 0.0043 or 0.0106 to 0.0236"
std::string feasible_words(const RegionReport& report) {
  std::string words;
  for (const auto& [low, high] : report.answer.feasible_f) {
    words += (words.empty() ? "" : " or ") + interval_digits(low, high, digits_of_f);
  }
  return words;
}

/// "it rests off centre: f is 55 % too large", of what decides.
std::string first_violation(const RegionReport& report) {
  const std::vector<design::Constraint>& all = report.answer.constraints;
  enum Rank { first, second, last, none };
  const auto rank = [back = returns(all)](const design::Constraint& now) {
    return now.satisfied || (!back && now.name == "stop") ? none
           : now.name == "start"                          ? first
           : now.name == "dead_zone"                      ? last
                                                          : second;
  };
  const auto decisive = std::ranges::min_element(all, {}, rank);
  return decisive == all.end() || rank(*decisive) == none
             ? "some hits of the range leave it too far off centre"  // all else it meets
             : "it " + violation(*decisive, task_of(report));
}

/// "The damper is admissible: f and delta may both be off by +-33.86 %.", or what is wrong.
std::string judgement(const RegionReport& report) {
  const design::RegionAnswer& answer = report.answer;
  const design::Limits& limits = report.request.limits;
  if (!answer.tolerance) {
    return format("The damper is not admissible: {}.", first_violation(report));
  }
  const std::string tolerance =
      tolerance_words(design::Limits{}, *answer.tolerance, *report.request.delta);
  return *answer.admissible ? format("The damper is admissible: {}.", tolerance)
                            : format("The damper is not admissible with a tolerance of {}: {}.",
                                     tolerance_text(limits, limits.tolerance), tolerance);
}

/// "Feasible f: 0.1 to 0.25.", and whether there are others.
std::string feasible_f(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  const std::size_t intervals = answer.intervals ? answer.intervals->size() : 1;
  return format("Feasible f{}: {}{}.", limits.tolerance > 0 ? " with the tolerance asked for" : "",
                feasible_words(report),
                intervals > 1
                    ? format("; of {} intervals this one has the most tolerant damper", intervals)
                    : "");
}

/// "2.1 mm to 8.2 mm or in 2 lower ranges"
std::string delta_words(const std::vector<Interval>& all, const Physical& physical) {
  constexpr std::size_t most_listed = 3;
  constexpr double conversion = 1 + 1e-12;  // the rounding of 3 mm to dimensionless and back
  const std::size_t lower = all.size() - std::min(all.size(), most_listed);
  std::string text;
  for (const auto& [low, high] : std::span(all).subspan(lower)) {
    const std::string least = length_limit(physical, low, true);
    text += format(
        "{}{}", text.empty() ? "" : " or ",
        std::isinf(high) ? format("at least {}", least)
        : low > 0   ? format("{} to {}", least, length_limit(physical, high * conversion, false))
        : high == 0 ? "0"
                    : format("up to {}", length_limit(physical, high * conversion, false)));
  }
  return text + (lower == 0   ? ""
                 : lower == 1 ? " or in a lower range"
                              : format(" or in {} lower ranges", lower));
}

/// "At f = 0.024, delta of 2.1 mm to 8.2 mm is admissible.", or what suits every feasible f, if
/// more than next to nothing does.
std::string feasible_delta(const RegionReport& report) {
  const bool tolerant = report.request.limits.tolerance > 0;
  const auto& all = report.answer.feasible_delta;
  if (const auto& f = report.request.f) {
    const char* const fits = tolerant ? "keeps the tolerance asked for" : "is admissible";
    return all->empty() ? format("At f = {:.9g} no delta {}.", *f, fits)
                        : format("At f = {:.9g}, delta of {} {}.", *f,
                                 delta_words(*all, report.physical), fits);
  }
  constexpr double narrow = 1e-4;  // of five digits the last
  return !all || all->empty() || all->back().low >= all->back().high * (1 - narrow)
             ? ""
             : format("With any of them, delta of {} {}.", delta_words(*all, report.physical),
                      tolerant ? "keeps that tolerance" : "is admissible");
}

/// Of several arrivals.
void add_strips(Document& document, const design::Problem& problem,
                const std::vector<design::Strip>& strips) {
  constexpr std::size_t most_listed = 10;
  if ((problem.arrivals == 1 && !problem.residual) || strips.empty()) {
    return;
  }
  Table table{{"arrival", "feasible f", "largest tolerance"}, {}};
  for (const design::Strip& strip : std::span(strips).first(std::min(most_listed, strips.size()))) {
    table.rows.push_back(
        {{strip.at_peak        ? "none, peak within the residual"
          : strip.arrival == 0 ? "none needed, rest within the residual"
                               : format("{}", strip.arrival),
          strip.f_lower ? interval_digits(*strip.f_lower, *strip.f_upper, digits_of_f)
                        : "none with the tolerance asked for",
          "+-" + percent_digits(strip.tolerance)}});
  }
  Section& section = document.section(
      problem.residual ? "Dampers that stop at each arrival, or before it within the residual"
                       : "Dampers that stop at each arrival",
      std::move(table));
  if (strips.size() > most_listed) {
    section.line(format("{} more arrivals have a damper; --json lists them all.",
                        strips.size() - most_listed));
  }
}

/// In forces and energies as well, if the mass is known.
void add_damper(Section& answer, const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const Physical& physical = report.physical;
  answer.row("damper",
             format("f = {:.9g}{}", *f, delta ? ", delta = " + length_shown(physical, *delta) : ""),
             Tone::heading);
  if (physical && physical->scales.mass_kg) {
    answer.row("", damper_words(physical, f, delta.value_or(0)));
  }
}

/// The least stroke, and with a damper the f that are feasible, which the verdict says without one.
void add_region(Section& answer, const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  constexpr int digits_of_tables = 7;  // which round: a stroke must not be below the least
  const design::Region& region = report.answer.region;
  if (region.beta_min == 0) {
    answer.row("least stroke",
               "as small as you like: with f just below the peak load the mass hardly moves");
  } else if (region.conflict != design::Conflict::no_arrival) {  // where no stroke helps
    answer.row(report.physical ? "least stroke" : "least beta",
               length_limit(report.physical, region.beta_min, true, digits_of_tables));
  }
  if (delta && region.feasible) {
    answer.row("feasible f", feasible_words(report) +
                                 (limits.tolerance > 0 ? ", with the tolerance asked for" : ""));
  }
}

}  // namespace

std::string verdict(const RegionReport& report) {
  if (report.request.delta) {
    return judgement(report);
  }
  if (!report.answer.region.feasible) {
    return none_admissible(report.answer, task_of(report));
  }
  const std::string of_f = feasible_f(report);
  const std::string of_delta = feasible_delta(report);
  return report.request.f ? format("{} {}", of_delta, of_f)
                          : format("{}{}{}", of_f, of_delta.empty() ? "" : " ", of_delta);
}

Document document(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  const Physical& physical = report.physical;
  Document document =
      answered("Admissible region", report,
               answer.admissible.value_or(answer.region.feasible) ? Tone::good : Tone::bad);
  add_strips(document, problem, answer.strips);
  if (!answer.region.feasible) {
    add_mends(document, answer, task_of(report));
  }
  if (report.catalogue) {
    add_parts(document, *report.catalogue, task_of(report));
  }
  if (f) {
    add_damper(document.answer, report);
  }
  if (delta) {
    const auto& feasible = answer.feasible_delta.value();
    document.answer.row("feasible delta", !feasible.empty()        ? delta_words(feasible, physical)
                                          : answer.region.feasible ? "none with this f"
                                                                   : "none with any f");
    add_constraints(document, answer.constraints, physical, of_first_swing(task_of(report)));
  }
  if (f && (!delta || stops_by_delta1(answer.constraints))) {
    document.answer.row("delta needed",
                        answer.delta1_exact
                            ? format("{} by the published criterion, {} by the exact one",
                                     length_limit(physical, answer.delta1_published.value(), true),
                                     length_limit(physical, *answer.delta1_exact, true))
                            : "none is enough: the motion does not return");
  }
  add_region(document.answer, report);
  if (answer.response && moves(*answer.response)) {
    add_motion(document.answer, shown_damper(report.request, answer), physical);
    add_works_for(document.answer, answer.works_for, task_of(report));
  }
  add_findings(document, report.findings, physical);
  return document;
}

}  // namespace stillpoint::report
