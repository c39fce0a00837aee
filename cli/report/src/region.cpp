// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "design_parts.hpp"
#include "format.hpp"
#include "sections.hpp"
#include "sentence.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

/// " It rests off centre: f is 55 % too large (return)." What decides is first. Where the mass does
/// not start, what the others say does not happen.
std::string violations(const RegionReport& report) {
  std::vector<design::Constraint> violated = report.answer.constraints;
  const bool back = returns(violated);
  std::erase_if(violated,
                [back](const auto& now) { return now.satisfied || (!back && now.name == "stop"); });
  std::ranges::stable_sort(violated, {}, [](const design::Constraint& now) {
    return now.name == "start" ? 0 : now.name == "dead_zone" ? 2 : 1;
  });
  if (violated.empty()) {
    return " Some hits of the range leave it too far off centre.";  // all else it meets
  }
  if (violated.size() == 1 && violated.front().name == "dead_zone") {
    return format(" It moves and rests as asked, but {} (dead zone).",
                  violation(violated.front(), task_of(report)));
  }
  const bool starts = violated.front().name != "start";
  std::string text;
  std::vector<std::string> others;
  for (const design::Constraint& now : violated) {
    if (starts || text.empty()) {
      text += format(" It {}{} ({}).", text.empty() ? "" : "also ", violation(now, task_of(report)),
                     in_words(now.name));
    } else {
      others.push_back(in_words(now.name));
    }
  }
  if (others.empty()) {
    return text;
  }
  const std::string last = others.back();
  others.pop_back();
  return text + format(" Also violated: {}{}{}.", fmt::join(others, ", "),
                       others.empty() ? "" : " and ", last);
}

/// "The damper is admissible: f and delta may both be off by +-33.86 %.", or what is wrong.
std::string judgement(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  const std::string damper = pulse && *delta > 0
                                 ? format("{} a notch that {}, the damper",
                                          answer.tolerance ? "With" : "Even with", acts_late)
                                 : "The damper";
  if (!answer.tolerance) {
    return damper + " is not admissible." + violations(report);
  }
  const std::string tolerance = tolerance_words(design::Limits{}, *answer.tolerance, *delta);
  const bool exact = !leaves_any(*answer.tolerance);
  return *answer.admissible
             ? format("{} is admissible{} {}.", damper, exact ? ", but" : ":", tolerance)
             : format("{} is not admissible with {}{} {}.", damper,
                      tolerance_shown(limits, limits.tolerance), exact ? ";" : ":", tolerance);
}

/// "Feasible f: 0.1 to 0.25.", and whether there are others.
std::string feasible_f(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  const std::size_t intervals = answer.intervals ? answer.intervals->size() : 1;
  return format("Feasible f{}: {}{}.", limits.tolerance > 0 ? " with the tolerance asked for" : "",
                feasible_words(answer, problem, limits),
                intervals > 1
                    ? format("; of {} intervals this one has the most tolerant damper", intervals)
                    : "");
}

/// The ranges of Delta that are feasible with an f, in rising order.
std::vector<Interval> feasible_at(const RegionReport& report, double f) {
  const design::RegionRequest& request = report.request;
  std::vector<Interval> all;
  const auto add = [&all](const std::optional<Interval>& delta) {
    if (delta && (delta->low < delta->high || delta->low == 0)) {  // delta > low
      all.push_back(*delta);
    }
  };
  if (request.pulse) {
    add(design::feasible_delta(design::pulse_request(request).problem, request.limits)(f));
  }
  for (const design::Strip& strip : report.answer.strips) {
    add(design::feasible_delta(request.problem, request.limits, strip.arrival, f));
  }
  return merged(std::move(all));
}

/// "delta from 2.1 mm to 8.2 mm or in 2 lower ranges"
std::string delta_words(const std::vector<Interval>& all, const Physical& physical) {
  constexpr std::size_t most_listed = 3;
  constexpr double conversion = 1 + 1e-12;  // the rounding of 3 mm to dimensionless and back
  const std::size_t lower = all.size() - std::min(all.size(), most_listed);
  std::string text;
  for (const auto& [low, high] : std::span(all).subspan(lower)) {
    const std::string least = length_limit(physical, low, true);
    text += format(
        "{}{}", text.empty() ? "delta " : " or ",
        std::isinf(high) ? format("of at least {}", least)
        : low > 0 ? format("from {} to {}", least, length_limit(physical, high * conversion, false))
        : high == 0 ? "of 0"
                    : format("up to {}", length_limit(physical, high * conversion, false)));
  }
  return text + (lower == 0   ? ""
                 : lower == 1 ? " or in a lower range"
                              : format(" or in {} lower ranges", lower));
}

/// "At f = 0.024, delta from 2.1 mm to 8.2 mm is admissible.", or what suits every feasible f; if
/// next to none does, what suits one of them.
std::string feasible_delta(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::Region& region = report.answer.region;
  const std::string_view fits = limits.tolerance == 0 ? "is admissible"
                                : f                   ? "keeps the tolerance asked for"
                                                      : "keeps it";
  const auto at = [&](double some_f, const std::vector<Interval>& all) {
    return format("At f = {:.9g}, {} {}.", some_f, delta_words(all, report.physical), fits);
  };
  if (f) {
    const auto all = feasible_at(report, *f);
    return all.empty() ? format("At f = {:.9g} no delta {}.", *f, fits) : at(*f, all);
  }
  const auto hardly_any = [](const std::vector<Interval>& all) {
    constexpr double narrow = 1e-4;  // of five digits the last
    return all.empty() || all.back().low >= all.back().high * (1 - narrow);
  };
  // With a single arrival the least Delta falls with f.
  const bool falls = !pulse && problem.arrivals == 1 && !problem.residual && problem.v0_low != 0.0;
  const auto with_any = falls ? feasible_at(report, *region.f_lower) : std::vector<Interval>();
  if (!hardly_any(with_any)) {
    return format("With any of them, {} {}.", delta_words(with_any, report.physical), fits);
  }
  const auto strip = std::ranges::find_if(
      report.answer.strips, [](const design::Strip& now) { return now.f_lower.has_value(); });
  const Interval of_f = strip == report.answer.strips.end()
                            ? Interval{*region.f_lower, *region.f_upper}
                            : Interval{*strip->f_lower, *strip->f_upper};
  const double middle = decimal_within(of_f.low, std::midpoint(of_f.low, of_f.high));
  const auto all = feasible_at(report, middle);
  return hardly_any(all) ? "" : at(middle, all);
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
    table.rows.push_back({{strip.at_peak        ? "none, peak within the residual"
                           : strip.arrival == 0 ? "none needed, rest within the residual"
                                                : format("{}", strip.arrival),
                           strip.f_lower ? range_digits(*strip.f_lower, *strip.f_upper)
                                         : "none with the tolerance asked for",
                           "+-" + percent_digits(strip.tolerance)}});
  }
  Section& section = document.section(
      problem.residual ? "Dampers that stop at each arrival, or before it within the residual"
                       : "Dampers that stop at each arrival");
  section.parts.emplace_back(std::move(table));
  if (strips.size() > most_listed) {
    section.line(format("{} more arrivals have a damper; --json lists them all.",
                        strips.size() - most_listed));
  }
}

}  // namespace

namespace {

/// What is said of the damper that is judged.
Advice judged(const RegionReport& report, const DesignReport& design) {
  Advice advice;
  advice.alarming = report.answer.admissible != true || !notch_sentence(design).empty();
  advice.remarks = judgement(report) + next_sentence(notch_sentence(design)) +
                   late_notch_words(design, "simulate ") + next_sentence(lock_sentence(report));
  return advice;
}

/// What the structure feels; nothing of a mass that stands still.
std::string felt_words(const RegionReport& report, const DesignReport& design,
                       const ToldPractice& told) {
  const design::RegionAnswer& answer = report.answer;
  return answer.response && moves(*answer.response)
             ? felt(task_of(report), {*report.request.f, *report.request.delta, 0},
                    {*answer.response, answer.arrival, answer.worst}, told,
                    inside_limit(design, report.physical))
             : "";
}

ToldPractice practice_told(const RegionReport& report) {
  return told_practice(task_of(report), report.answer.practice, *report.request.f,
                       report.request.delta.value_or(0));
}

}  // namespace

Advice advice(const RegionReport& report) {
  if (!report.request.delta) {
    return {};
  }
  const DesignReport design = as_design(report);
  Advice advice = judged(report, design);
  if (const std::string words = felt_words(report, design, practice_told(report)); !words.empty()) {
    advice.remarks += next_sentence("the structure feels " + words);
  }
  return advice;
}

DesignReport as_design(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  DesignReport design;
  if (answer.admissible != true || !answer.practice || !answer.response) {
    return design;
  }
  design.physical = report.physical;
  design.result.request = {problem, limits, {}, pulse, ranges};
  design::Found& finding = design.result.finding.emplace();
  finding.point = {*f, *delta, *answer.tolerance};
  finding.response = *answer.response;
  finding.practice = answer.practice;
  if (answer.shown) {
    finding.pulse.emplace();
    std::tie(finding.pulse->pulse, finding.pulse->p) = *answer.shown;
  }
  return design;
}

Document document(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  Document document;
  document.title = "Admissible region";
  Section& task = add_problem(document, problem, limits, report.physical, pulse.has_value());
  if (pulse) {
    add_pulse(task, *pulse, ranges, report.physical);
  }
  add_region(document, answer, problem, limits, report.physical).detail = false;
  add_strips(document, problem, answer.strips);
  if (answer.region.feasible) {
    const std::string of_f = feasible_f(report);
    const std::string of_delta = feasible_delta(report);
    document.verdict =
        format("{}{}{}", f ? of_delta : of_f, of_delta.empty() ? "" : " ", f ? of_f : of_delta);
    document.tone = Tone::good;
    if (pulse && !delta) {
      document.verdict += format(" This is for a notch that {}.", acts_late);
    }
  } else {
    add_emptiness(document, answer, task_of(report));
  }
  if (report.catalogue) {
    const auto& parts = report.catalogue->parts;
    const std::string best =
        parts.front().admissible ? "; the most tolerant is " + parts.front().part.name : "";
    document.verdict += format(" {}{}.", how_many_fit(parts), best);
    add_parts(document, *report.catalogue, task_of(report));
  }
  if (!f) {
    return document;
  }
  const DesignReport design = delta ? as_design(report) : DesignReport();
  const std::string with = with_ideal(design);
  Section& section = document.section(format("At f = {:.9g}{}", *f, with));
  const ToldPractice told = practice_told(report);
  const bool by_delta1 = !delta || stops_by_delta1(answer.constraints);
  if (by_delta1 && !answer.delta1_exact) {
    section.row("Delta1(f)", "none: the motion does not return");
  }
  add_damper(section, {*f, delta.value_or(0)},
             by_delta1 && answer.delta1_exact
                 ? DeltaNeeds{answer.delta1_published, answer.delta1_exact}
                 : DeltaNeeds(),
             told, report.physical);
  if (delta) {
    section.row("delta", length_shown(report.physical, *delta));
    const Advice said = judged(report, design);
    document.verdict = format("{} {}", said.remarks, document.verdict);
    document.tone = said.alarming ? Tone::bad : Tone::good;
    add_brake(document.answer, report.physical, *f, "note");
    if (const auto& response = answer.response; response && moves(*response)) {
      const ToldMotion motion{*response, answer.arrival, answer.worst,
                              answer.tolerance.has_value()};
      add_motion(document.answer, task_of(report), motion, felt_words(report, design, told));
    }
    if (pulse && !no_notch_works(design)) {
      add_start(document.answer, {*f, *delta, ranges.k_low.value_or(design::peak_load(*pulse))},
                "delta/(k - f)", report.physical);
    }
    add_works_for(document.answer, answer.works_for, task_of(report));
    add_weak_hits(document.answer, problem, *delta, report.physical);
    if (told.lines) {
      add_practice(document.detail(format("In practice{}{}",
                                          told.which.empty() ? "" : ": " + told.which, with)),
                   told, report.physical);
    }
    add_constraints(document, answer.constraints, limits, answer.response.value_or(Response()),
                    report.physical)
        .heading += with;
  }
  return document;
}

}  // namespace stillpoint::report
