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

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/region_answer.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <utility>

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

/// Says so beforehand where the motion takes minutes, which needs a raised limit.
Simulation free_simulation(SimulationRequest request) {
  constexpr double half_cycles_per_minute = 4e9;
  const auto limit = std::exchange(request.half_cycle_limit, {});
  try {
    if (limit.value_or(0) > FreeOptions().half_cycle_limit) {
      return simulate(request);
    }
  } catch (const TooManyHalfCycles& excess) {
    const double minutes = excess.bound().value_or(0) / half_cycles_per_minute;
    if (minutes > 2 && excess.bound() <= limit) {
      fmt::print(stderr,
                 "stillpoint: up to {:.3g} half-cycles: this may take some {:.3g} minutes\n",
                 *excess.bound(), minutes);
    }
  }
  request.half_cycle_limit = limit;
  return simulate(request);
}

/// A forced run is watched over; a free one has a limit.
Simulation watched(const SimulationRequest& request) {
  if (!is_forced(request)) {
    return free_simulation(request);
  }
  const double end = request.t_end.value_or(0);
  Progress progress(progress_in_tau(end), end);
  double reached = 0;
  Simulation answer = simulate(request, [&](double tau) {
    reached = tau;
    progress.announce_minutes(tau);
    return progress.goes_on(tau);
  });
  if (Progress::interrupted()) {
    throw Interrupted(fmt::format("interrupted at tau = {:.6g}, nothing is written", reached));
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
  const DesignInput input = design_input(settings);
  const design::DesignResult result = design::design(input.request);
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
  const design::RegionAnswer answer = design::answer(input.request);
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
  const Simulation answer = watched(input.request);
  if (input.trajectory) {
    output.write_file("trajectory", *input.trajectory,
                      trajectory_csv(answer.trajectory, input.physical));
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
