// SPDX-License-Identifier: MIT
#include "text_report.hpp"

#include "pulse_text.hpp"
#include "text_sections.hpp"

#include <fmt/format.h>

namespace stillpoint::cli {

using fmt::format;

std::string design_text(const DesignInput& input, const design::DesignResult& result,
                        const std::optional<std::string>& title, Style style) {
  const auto& [problem, limits, search, pulse] = result.request;
  Page page(style);
  add_title(page, "Damper design", title);
  auto physical = input.physical;
  if (physical) {
    physical->velocity_m_per_s = problem.v0 * physical->scales.velocity_m_per_s;
  }
  add_problem(page, problem, limits, physical);
  if (pulse) {
    add_pulse(page, *pulse, input.physical);
  }
  page.row("objective", name(search.objective));
  add_region(page, result.region, input.physical);
  if (!result.finding) {
    add_emptiness(page, result.reason, result.mends, result.joint_mend, input.physical);
    return page.text();
  }
  const design::Finding& finding = *result.finding;
  page.section("Design");
  page.row("f", figure(finding.point.f), Tone::heading);
  page.row("delta", figure(finding.point.delta) + in_metres(input.physical, finding.point.delta),
           Tone::heading);
  page.row("tolerance", format("+-{:.4g} % of f and delta at once", 100 * finding.point.tolerance));
  page.row("Delta1(f)",
           format("{:.6g} published, {} exact", design::delta1_published(problem, finding.point.f),
                  figure(design::delta1_exact(problem, finding.point.f))));
  if (input.physical) {
    add_damper_physics(page, *input.physical, finding.point.f, finding.point.delta);
  }
  add_constraints(page, finding.constraints);
  page.section("Motion");
  add_response(page, finding.response, input.physical);
  page.row("use of beta", format("{:.4g} %", 100 * finding.response.peak_amplitude / problem.beta));
  if (finding.pulse) {
    add_pulse_check(page, *finding.pulse, input.physical);
  }
  add_checks(page, finding.cross_check);
  page.section("Search");
  page.line(format("NLopt {} {}: {} after {} evaluations, {:.2g} ms", design::nlopt_version(),
                   finding.search.algorithm, finding.search.status, finding.search.evaluations,
                   1e3 * finding.search.wall_time_s));
  return page.text();
}

std::string region_text(const RegionInput& input, const design::RegionAnswer& answer,
                        const std::optional<std::string>& title, Style style) {
  Page page(style);
  add_title(page, "Admissible region", title);
  add_problem(page, input.request.problem, input.request.limits, input.physical);
  add_region(page, answer.region, input.physical);
  if (!answer.region.feasible) {
    add_emptiness(page, answer.reason, answer.mends, answer.joint_mend, input.physical);
  }
  if (input.request.f) {
    page.section(format("At f = {:.6g}", *input.request.f));
    page.row("Delta1 published", figure(answer.delta1_published));
    page.row("Delta1 exact", answer.delta1_exact ? figure(*answer.delta1_exact)
                                                 : "none: f > f3, the motion does not return");
    if (input.physical) {
      add_damper_physics(page, *input.physical, *input.request.f, input.request.delta.value_or(0));
    }
  }
  if (answer.admissible) {
    page.row("delta",
             figure(*input.request.delta) + in_metres(input.physical, *input.request.delta));
    page.row("the point is", *answer.admissible ? "admissible" : "not admissible",
             *answer.admissible ? Tone::good : Tone::bad);
    if (answer.tolerance) {
      page.row("withstands", format("+-{:.4g} % of f and delta at once{}", 100 * *answer.tolerance,
                                    input.request.limits.tolerance > *answer.tolerance
                                        ? format(", less than the {:.4g} % asked for",
                                                 100 * input.request.limits.tolerance)
                                        : ""));
    }
    add_constraints(page, answer.constraints);
  }
  return page.text();
}

std::string simulate_text(const SimulateInput& input, const Simulation& answer,
                          const std::optional<std::string>& title, Style style) {
  Page page(style);
  add_title(page, is_forced(input.request) ? "Forced motion" : "Free motion", title);
  page.section("Scene");
  if (input.physical) {
    add_physical_input(page, *input.physical);
  }
  page.row("dimensionless", format("v0 = {:.6g}   p = {:.6g}   x0 = {:.6g}", input.request.start.v0,
                                   input.request.oscillator.p, input.request.start.x0));
  page.row("damper", format("f = {:.6g}   delta = {:.6g}{}", input.request.oscillator.f,
                            input.request.oscillator.delta,
                            in_metres(input.physical, input.request.oscillator.delta)));
  if (input.physical) {
    add_damper_physics(page, *input.physical, input.request.oscillator.f,
                       input.request.oscillator.delta);
  }
  if (is_forced(input.request)) {
    add_excitation(page, input);
  }
  page.section("Motion");
  add_response(page, answer.response, input.physical, answer.forced ? forced_margin : free_margin);
  if (answer.forced) {
    add_forced_response(page, *answer.forced, input.physical);
  }
  add_half_cycles(page, answer);
  return page.text();
}

}  // namespace stillpoint::cli
