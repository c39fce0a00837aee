// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "json_report.hpp"
#include "request.hpp"
#include "text_report.hpp"
#include "trajectory_csv.hpp"

#include <stillpoint/core/input_error.hpp>

namespace stillpoint::cli {

namespace {

/// The JSON report where it was asked for, else the one for people. Either is made only if wanted.
template <class Json, class Text>
void report(const Settings& settings, const Json& json, const Text& text, Output& output) {
  constexpr int indent = 2;
  const auto path = settings.text("output");
  const bool print_json = settings.flag("json");
  const std::string report = print_json || path ? json().dump(indent) + "\n" : std::string();
  output.print(print_json ? report : text(settings.text("title"), style_for_standard_output()));
  if (path) {
    output.write_file("output", *path, report);
  }
}

}  // namespace

ExitCode exit_code(const design::DesignResult& result) {
  if (!result.finding) {
    return exit_infeasible;
  }
  return result.finding->cross_check.passed ? exit_done : exit_check_failed;
}

ExitCode run_design(const Settings& settings, Output& output) {
  const DesignInput input = design_input(settings);
  const design::DesignResult result = design::design(input.request);
  report(
      settings, [&] { return design_json(input, result); },
      [&](const auto& title, Style style) { return design_text(input, result, title, style); },
      output);
  return exit_code(result);
}

ExitCode run_region(const Settings& settings, Output& output) {
  const RegionInput input = region_input(settings);
  RegionAnswer answer;
  answer.region = design::admissible_region(input.problem, input.limits);
  answer.reason = design::reason(answer.region, input.problem, input.limits);
  answer.mends = design::mends(input.problem, input.limits);
  if (input.f) {
    answer.delta1_published = design::delta1_published(input.problem, *input.f);
    answer.delta1_exact = design::delta1_exact(input.problem, *input.f);
  }
  if (input.delta) {
    const auto list = design::constraints(input.problem, *input.f, *input.delta);
    answer.constraints.assign(list.begin(), list.end());
    answer.admissible = design::admissible(input.problem, input.limits, *input.f, *input.delta);
  }
  report(
      settings, [&] { return region_json(input, answer); },
      [&](const auto& title, Style style) { return region_text(input, answer, title, style); },
      output);
  return answer.region.feasible ? exit_done : exit_infeasible;
}

ExitCode run_simulate(const Settings& settings, Output& output) {
  const SimulateInput input = simulate_input(settings);
  Ask ask;
  ask.half_cycle_limit = input.half_cycle_limit;
  SimulateAnswer answer;
  answer.response = free_response(input.oscillator, input.start, ask);
  answer.half_cycles = first_half_cycles(input.oscillator, input.start, input.max_half_cycles);
  if (input.trajectory) {
    output.write_file("trajectory", *input.trajectory, trajectory_csv(input, answer.response));
  }
  report(
      settings, [&] { return simulate_json(input, answer); },
      [&](const auto& title, Style style) { return simulate_text(input, answer, title, style); },
      output);
  return exit_done;
}

}  // namespace stillpoint::cli
