// SPDX-License-Identifier: MIT
#include "input/excitation.hpp"
#include "input/request.hpp"

#include <stillpoint/core/forced_motion.hpp>
#include <stillpoint/design/motion_findings.hpp>

namespace stillpoint::cli {

namespace {

/// For a free motion the end is that of its trajectory.
std::optional<double> free_end(const Settings& settings, const Physical& physical) {
  const auto t_end = end_of_run(settings, physical);
  if (t_end && !settings.has("trajectory")) {
    throw UsageError(fmt::format(
        "{} needs a trajectory or an excitation: give --trajectory FILE or --excitation as well",
        settings.given(Rivals::end)->name));
  }
  return t_end;
}

}  // namespace

std::optional<double> half_cycle_limit(const Settings& settings) {
  const std::optional<double> limit = settings.number("half-cycle-limit");
  if (limit) {
    require_within("half-cycle-limit", *limit, 1, 1e15);
  }
  return limit;
}

report::MotionReport simulate_input(const Settings& given) {
  const Settings settings = given.over_weight();
  // A motion needs a start, unless an excitation moves it from rest.
  const bool from_rest = settings.first([](const Option& option) {
    return option.traits.load != Load::none;
  }) != nullptr || settings.has("excitation");
  const MotionInput motion = motion_input(settings, Command::simulate, from_rest);
  report::MotionReport input;
  SimulationRequest& request = input.request;
  input.physical = motion.physical;
  request.start = {motion.x0, motion.v0};
  request.oscillator = oscillator_input(settings, motion);
  request.half_cycle_limit = half_cycle_limit(settings);
  request.max_half_cycles = settings.integer("max-half-cycles").value_or(request.max_half_cycles);
  if (settings.has("trajectory")) {
    request.samples = settings.integer("samples").value_or(1000);
  }
  request.surface = surface_input(settings, motion.physical);
  require_valid(request.oscillator, request.start);
  require_valid(request.oscillator, request.surface);
  auto excitation = excitation_input(settings, motion.physical, motion.p);
  if (!excitation) {
    request.t_end = free_end(settings, motion.physical);
    return input;
  }
  request.t_end = forced_end(settings, excitation->excitation, motion.physical);
  request.excitation = std::move(excitation->excitation);
  input.record = std::move(excitation->record);
  require_valid(request.oscillator, request.start, request.excitation, request.t_end);
  return input;
}

Settings traced(Settings settings) {
  const bool ends_free = !excitation_type(settings) && settings.given(Rivals::end) != nullptr;
  if (settings.has("samples") || ends_free) {
    settings.set("trajectory", std::string("-"));
  }
  return settings;
}

report::MotionReport motion_report(const Settings& settings, const std::function<bool()>& go_on) {
  report::MotionReport report = simulate_input(traced(settings));
  report.answer = simulate(report.request, [&](double /*tau*/) { return go_on(); });
  if (!report.answer.cancelled) {
    report.findings = design::findings_of(report.request, report.answer);
  }
  return report;
}

}  // namespace stillpoint::cli
