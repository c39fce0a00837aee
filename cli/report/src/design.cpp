// SPDX-License-Identifier: MIT
#include "sections.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/report.hpp>

#include <fmt/format.h>

#include <cmath>

namespace stillpoint::report {

using fmt::format;

namespace {

void add_pulse(Section& task, const design::Pulse& pulse, const Physical& physical) {
  const double lambda = design::angular_frequency(pulse);
  task.row("pulse", format("{}, k = {:.6g}, lambda = {}", design::name(pulse),
                           design::peak_load(pulse), frequency_text(physical, lambda)));
  const double lasts = duration(design::excitation(pulse)).value();
  task.row("duration", time_text(physical, lasts));
}

void add_damper(Document& document, const design::Problem& problem,
                const design::DesignPoint& point, const Physical& physical) {
  Section& section = document.section("Design");
  section.row("f", digits(point.f), Tone::heading);
  section.row("delta", length_text(physical, point.delta), Tone::heading);
  section.row("tolerance", format("+-{:.4g} % of f and delta at once", 100 * point.tolerance));
  section.row("Delta1(f)",
              format("{:.6g} published, {} exact", design::delta1_published(problem, point.f),
                     digits(design::delta1_exact(problem, point.f))));
  add_damper_physics(section, physical, point.f, point.delta);
}

/// "0.28 % more than", "0.28 % less than": the reduced figure against the true one.
std::string off_by(double relative) {
  return format("{:.2g} % {}", 100 * std::abs(relative), relative < 0 ? "less than" : "more than");
}

std::string warning_text(design::PulseWarning warning, const design::PulseCheck& check) {
  switch (warning) {
    case design::PulseWarning::pulse_not_short:
      return format(
          "the pulse is not short, p/lambda = {:.3g}: the design assumes an initial velocity, and "
          "the error of that grows like the square of p/lambda",
          check.shortness);
    case design::PulseWarning::friction_not_small:
      return format(
          "f is not small against k, f/k = {:.3g}: friction takes a large part of the velocity "
          "while the pulse lasts",
          check.friction_ratio);
  }
  return {};
}

void add_pulse_check(Document& document, const design::PulseCheck& check,
                     const Physical& physical) {
  Section& section = document.section("Under the pulse itself");
  section.row("reduced to",
              format("v0 = {:.6g} at tau = {:.6g}", check.start.speed, check.start.tau));
  section.row("p/lambda, f/k", format("{:.4g}, {:.4g}", check.shortness, check.friction_ratio));
  add_response(section, check.response, physical);
  section.row("reduction", format("its peak is {} this", off_by(check.peak_error)));
  if (check.stop_time_error) {
    section.row("", format("its stop time is {} this", off_by(*check.stop_time_error)));
  }
  for (const design::PulseWarning warning : check.warnings) {
    section.line(format("Note: {}.", warning_text(warning, check)), Tone::bad);
  }
}

/// What a notch of finite width changes.
void add_built_notch(Document& document, const design::BuiltNotch& built,
                     const design::Finding& finding, const Physical& physical) {
  const auto& [width, friction, response] = built;
  const Response& paper = finding.pulse ? finding.pulse->response : finding.response;
  Section& section = document.section("With the notch as built");
  section.row("width", length_text(physical, width));
  section.row("friction inside", format("f + delta/width = {:.6g}", friction));
  if (response.half_cycles == 0) {
    section.line("This notch holds the mass all through the pulse.", Tone::bad);
    return;
  }
  section.row("outcome", outcome_phrase(response.outcome));
  section.row("peak", length_text(physical, response.peak_amplitude));
  if (response.stop_position && response.stop_time) {
    section.row("rest", format("x = {}", length_text(physical, *response.stop_position)));
    section.row("stop time", time_text(physical, *response.stop_time));
  }
  if (response.stop_time && paper.stop_time) {
    section.row("change", format("stops {:.3g} % {} than with the paper's notch",
                                 100 * std::abs(*response.stop_time / *paper.stop_time - 1),
                                 *response.stop_time < *paper.stop_time ? "earlier" : "later"));
  }
  section.row("acceleration",
              format("up to {:.4g} g is transmitted, the notch included ({:.4g} g "
                     "with the paper's, outside of it)",
                     response.peak_absolute_acceleration, paper.peak_absolute_acceleration));
}

std::string judgement(const design::CheckMethod& method) {
  if (!method.passed) {
    return "disagrees";
  }
  return method.decided ? "agrees" : "agrees in the peak; too near a tie to tell more";
}

void add_checks(Document& document, const design::CrossCheck& check) {
  Table table{{"", "peak", "stop time", "half-cycles", "relative error", "allowed", "time", ""},
              {}};
  for (const design::CheckMethod& method : check.methods) {
    table.rows.push_back(
        {{std::string(method.name), digits(method.peak_amplitude), digits(method.stop_time),
          format("{:.0f}", method.half_cycles), format("{:.1e}", method.relative_error),
          format("{:.1e}", method.tolerance), format("{:.1f} us", 1e6 * method.wall_time_s),
          judgement(method)},
         method.passed ? Tone::good : Tone::bad});
  }
  document.section(check.passed ? "Cross-check: agrees" : "Cross-check: DISAGREES")
      .parts.emplace_back(std::move(table));
}

std::string verdict(const design::Finding& finding, const Physical& physical) {
  const auto& [f, delta, tolerance] = finding.point;
  std::string text =
      format("f = {:.6g}, delta = {}; both may be off by +-{:.4g} %. The cross-check {}.", f,
             length_text(physical, delta), 100 * tolerance,
             finding.cross_check.passed ? "agrees" : "DISAGREES");
  if (finding.pulse) {
    for (const design::PulseWarning warning : finding.pulse->warnings) {
      text += warning == design::PulseWarning::pulse_not_short
                  ? " The pulse is not short: the reduction to a velocity is rough."
                  : " Friction is not small against the pulse.";
    }
  }
  return text;
}

}  // namespace

Document document(const DesignReport& report) {
  const auto& [problem, limits, search, pulse] = report.result.request;
  Physical physical = report.physical;
  if (physical) {  // a pulse leaves another velocity than was given
    physical->velocity_m_per_s = problem.v0 * physical->scales.velocity_m_per_s;
  }
  Document document;
  document.title = "Damper design";
  Section& task = add_problem(document, problem, limits, physical);
  if (pulse) {
    add_pulse(task, *pulse, physical);
  }
  task.row("objective", std::string(name(search.objective)));
  add_region(document, report.result.region, physical);
  if (!report.result.finding) {
    add_emptiness(document, report.result, physical);
    return document;
  }
  const design::Finding& finding = *report.result.finding;
  document.verdict = verdict(finding, physical);
  document.tone = finding.cross_check.passed ? Tone::good : Tone::bad;
  add_damper(document, problem, finding.point, physical);
  add_constraints(document, finding.constraints);
  Section& motion = document.section("Motion");
  add_response(motion, finding.response, physical);
  motion.row("use of beta",
             format("{:.4g} %", 100 * finding.response.peak_amplitude / problem.beta));
  if (finding.pulse) {
    add_pulse_check(document, *finding.pulse, physical);
  }
  if (report.built_notch) {
    add_built_notch(document, *report.built_notch, finding, physical);
  }
  add_checks(document, finding.cross_check);
  document.section("Search").line(format("NLopt {} {}: {} after {} evaluations, {:.2g} ms",
                                         design::nlopt_version(), finding.search.algorithm,
                                         finding.search.status, finding.search.evaluations,
                                         1e3 * finding.search.wall_time_s));
  return document;
}

}  // namespace stillpoint::report
