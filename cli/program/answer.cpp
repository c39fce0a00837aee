// SPDX-License-Identifier: MIT
#include "answer.hpp"

#include "input/motion.hpp"
#include "input/request.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>

namespace stillpoint::cli {

ExitCode exit_code(const design::DesignResult& result) {
  if (!result.finding) {
    return exit_infeasible;
  }
  return result.finding->cross_check.passed ? exit_done : exit_check_failed;
}

ExitCode exit_code(const design::RecordDesign& result) {
  if (result.search.interrupted) {
    return exit_interrupted;
  }
  if (!result.finding) {
    return exit_infeasible;
  }
  return result.finding->check.passed ? exit_done : exit_check_failed;
}

namespace {

/// What is not the paper's notch.
std::optional<design::NotchShape> notch_shape(const Settings& settings, const DesignInput& input) {
  design::NotchShape shape{notch_width(settings, input.physical)};
  shape.hold = settings.number("hold").value_or(shape.hold);
  const Oscillator oscillator{input.request.problem.p, 0, 0, shape.hold};
  require_valid(oscillator);
  require_valid(oscillator, Surface{shape.width, {}});
  const bool asked_for = shape.width || std::isfinite(shape.hold);
  return asked_for ? std::optional(shape) : std::nullopt;
}

}  // namespace

report::DesignReport design_report(const Settings& settings) {
  require_options_for(settings, DesignFor::hit);
  DesignInput input = design_input(settings);
  const std::optional<design::NotchShape> notch = notch_shape(settings, input);
  report::DesignReport report;
  report.physical = input.physical;
  if (const auto parts = catalogue_input(settings, input.request.problem.p, input.physical)) {
    design::Choice choice = design::choose(input.request, *parts);
    report.result = std::move(choice.result);
    report.catalogue = {*settings.text("catalogue"), std::move(choice.parts)};
  } else {
    report.result = design::design(input.request);
  }
  report.trade_offs = settings.integer("trade-off");
  if (report.trade_offs) {
    const auto& [problem, limits, search, pulse, ranges] = input.request;
    if (pulse) {
      throw UsageError("trade-off and pulse exclude each other: the front is that of a velocity");
    }
    report.trade_off = design::trade_off(problem, limits, *report.trade_offs);
  }
  if (notch && report.result.finding) {
    design::DesignRequest shown = report.result.request;
    if (const auto& check = report.result.finding->pulse) {
      shown.pulse = check->pulse;
      shown.problem.p = check->p;
    }
    report.built_notch = built_notch(shown, report.result.finding->point, *notch);
  }
  return report;
}

report::RegionReport region_report(const Settings& settings) {
  const RegionInput input = region_input(settings);
  report::RegionReport report{input.request, design::answer(input.request), input.physical, {}};
  if (const auto parts = catalogue_input(settings, input.request.problem.p, input.physical)) {
    const auto& [problem, limits, f, delta] = input.request;
    report.catalogue = {*settings.text("catalogue"),
                        design::ranked(problem, limits, design::Objective::robust, *parts)};
  }
  return report;
}

report::MotionReport motion_report(const Settings& settings, const GoOn& go_on) {
  Settings wanted = settings;
  const bool forced = settings.has("excitation") || settings.has("record");
  if (settings.has("samples") || (!forced && (settings.has("t-end") || settings.has("end-time")))) {
    wanted.set(*find_option("trajectory"), std::string("-"));
  }
  SimulateInput input = simulate_input(wanted);
  Simulation motion = simulate(input.request, [&](double /*tau*/) { return go_on(); });
  return {std::move(input.request), std::move(motion), std::move(input.record), input.physical};
}

namespace {

std::unique_ptr<Answer> design_answer(const Settings& settings, const GoOn& go_on) {
  if (!designs_under_records(settings)) {
    return answer_of(design_report(settings));
  }
  const report::RecordDesignInput input = record_design_input(settings);
  return answer_of(report::RecordDesignReport{
      design::design(input.request, [&](const auto& /*progress*/) { return go_on(); }),
      input.physical});
}

std::unique_ptr<Answer> spectrum_answer(const Settings& settings, const GoOn& go_on) {
  report::SpectrumReport found = spectrum_input(settings);
  found.result = design::spectrum(found.result.request, [&](double /*done*/) { return go_on(); });
  return answer_of(std::move(found));
}

}  // namespace

std::unique_ptr<Answer> answer(Command command, const Settings& settings, const GoOn& go_on) {
  switch (command) {
    case Command::design:
      return design_answer(settings, go_on);
    case Command::region:
      return answer_of(region_report(settings));
    case Command::simulate:
      return answer_of(motion_report(settings, go_on));
    case Command::spectrum:
      return spectrum_answer(settings, go_on);
    case Command::sweep:
    case Command::accuracy:
    case Command::init:
    case Command::explore:
      break;
  }
  throw UsageError(fmt::format("{}: is for the program alone", name(command)));
}

}  // namespace stillpoint::cli
