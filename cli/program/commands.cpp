// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "accuracy.hpp"
#include "accuracy_report.hpp"
#include "json_report.hpp"
#include "pictures.hpp"
#include "progress.hpp"
#include "request.hpp"
#include "text_report.hpp"
#include "trajectory_csv.hpp"

#include <stillpoint/core/forced_half_cycles.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/pulse_design.hpp>

#include <fmt/format.h>

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

design::DesignResult answer(const DesignInput& input) {
  const auto& [problem, limits, search] = input.request;
  return input.pulse
             ? design::design(
                   {{*input.pulse, problem.p, problem.beta, problem.criterion}, limits, search})
             : design::design(input.request);
}

SimulateAnswer free_answer(const SimulateInput& input) {
  FreeOptions options;
  options.half_cycle_limit = input.half_cycle_limit.value_or(options.half_cycle_limit);
  SimulateAnswer answer;
  answer.response = free_response(input.oscillator, input.start, options);
  answer.half_cycles = first_half_cycles(input.oscillator, input.start, input.max_half_cycles);
  if (input.trajectory) {
    answer.trajectory = free_trajectory_csv(input, answer.response);
  }
  return answer;
}

/// A motion that excitation throws far rests late; where it is listed it must be followed until
/// then.
void require_followable(const SimulateInput& input, double horizon) {
  const double latest = largest_phase / input.oscillator.p;
  if (!input.t_end && horizon > latest) {
    throw InputError::missing(
        "t-end", fmt::format("the motion goes on to tau = {:.6g} and can be followed up to {:.6g}: "
                             "give --t-end",
                             horizon, latest));
  }
}

SimulateAnswer forced_answer(const SimulateInput& input) {
  const Excitation& excitation = input.excitation->excitation;
  Progress progress(progress_in_tau(input.t_end.value_or(0)), input.t_end.value_or(0));
  ForcedOptions options;
  options.t_end = input.t_end;
  options.half_cycle_limit = input.half_cycle_limit;
  const auto goes_on = [&progress](double tau) { return progress.goes_on(tau); };
  options.go_on = [&](double tau) {
    progress.announce_minutes(tau);
    return goes_on(tau);
  };
  SimulateAnswer answer;
  const auto trace = [&](double horizon) {
    if (input.trajectory && !answer.trajectory) {
      answer.trajectory = forced_trajectory_csv(input, horizon, goes_on);
    }
    if (Progress::interrupted()) {
      throw Interrupted("interrupted while tracing the motion, nothing is written");
    }
  };
  if (input.t_end) {
    trace(*input.t_end);  // first: a run that is too long for it shall not be followed for nothing
  }
  answer.forced = forced_response(input.oscillator, input.start, excitation, options);
  if (answer.forced->cancelled) {
    throw Interrupted(fmt::format("interrupted at tau = {:.6g}, nothing is written",
                                  answer.forced->end_time.value_or(0)));
  }
  const Response& what_any_motion_has = *answer.forced;
  answer.response = what_any_motion_has;
  const double horizon = forced_horizon(input, *answer.forced);
  require_followable(input, horizon);
  trace(horizon);
  answer.half_cycles = forced_half_cycles(input.oscillator, input.start, excitation, horizon,
                                          input.max_half_cycles, goes_on);
  if (Progress::interrupted()) {
    throw Interrupted("interrupted while listing half-cycles, nothing is written");
  }
  return answer;
}

}  // namespace

ExitCode exit_code(const design::DesignResult& result) {
  if (!result.finding) {
    return exit_infeasible;
  }
  return result.finding->cross_check.passed ? exit_done : exit_check_failed;
}

ExitCode run_design(const Settings& settings, Output& output) {
  DesignInput input = design_input(settings);
  const design::DesignResult result = answer(input);
  if (input.physical) {
    input.physical->velocity_m_per_s =
        result.request.problem.v0 * input.physical->scales.velocity_m_per_s;
  }
  if (wants_pictures(settings)) {
    write_pictures(settings, Command::design, design_page(input, result), output);
  }
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
  answer.joint_mend = design::joint_mend(input.problem, input.limits);
  if (input.f) {
    answer.delta1_published = design::delta1_published(input.problem, *input.f);
    answer.delta1_exact = design::delta1_exact(input.problem, *input.f);
  }
  if (input.delta) {
    answer.constraints = design::constraints(input.problem, input.limits, *input.f, *input.delta);
    answer.tolerance =
        design::largest_tolerance(input.problem, input.limits, *input.f, *input.delta);
    answer.admissible = design::admissible(input.problem, input.limits, *input.f, *input.delta);
  }
  if (wants_pictures(settings)) {
    write_pictures(settings, Command::region, region_page(input, answer), output);
  }
  report(
      settings, [&] { return region_json(input, answer); },
      [&](const auto& title, Style style) { return region_text(input, answer, title, style); },
      output);
  return answer.region.feasible ? exit_done : exit_infeasible;
}

ExitCode run_simulate(const Settings& settings, Output& output) {
  const SimulateInput input = simulate_input(settings);
  const SimulateAnswer answer = input.excitation ? forced_answer(input) : free_answer(input);
  if (answer.trajectory) {
    output.write_file("trajectory", *input.trajectory, *answer.trajectory);
  }
  if (wants_pictures(settings)) {
    write_pictures(settings, Command::simulate, simulate_page(input, answer), output);
  }
  report(
      settings, [&] { return simulate_json(input, answer); },
      [&](const auto& title, Style style) { return simulate_text(input, answer, title, style); },
      output);
  return exit_done;
}

ExitCode run_accuracy(const Settings& settings, Output& output) {
  const SimulateInput input = simulate_input(settings);
  const AccuracyAnswer answer = compare_methods(input);
  report(
      settings, [&] { return accuracy_json(input, answer); },
      [&](const auto& title, Style style) { return accuracy_text(input, answer, title, style); },
      output);
  return exit_done;
}

}  // namespace stillpoint::cli
