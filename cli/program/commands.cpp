// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "input/motion.hpp"
#include "input/request.hpp"
#include "messages.hpp"
#include "progress.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/report/progress_words.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>
#include <stillpoint/report/spectrum.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace stillpoint::cli {

namespace {

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
      remark(fmt::format("up to {:.3g} half-cycles: this may take some {:.3g} minutes",
                         *excess.bound(), minutes));
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
  Progress progress([end](double tau, double) { return report::progress_in_tau(tau, end); }, end);
  double reached = 0;
  // A trajectory up to t_end comes first. It is too long for its limit before it takes minutes.
  bool traced = !(request.t_end && request.samples);
  Simulation answer = simulate(request, [&](double tau) {
    traced = traced || tau < reached;
    reached = tau;
    if (traced) {
      progress.announce_minutes(tau);
    }
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

/// An interrupt ends the search with the best so far.
design::RecordDesign watched(const report::RecordDesignInput& input) {
  design::RecordProgress last;
  Progress progress([&](double, double) { return report::progress_words(last, input.physical); },
                    1);
  return design::design(input.request, [&](const design::RecordProgress& now) {
    last = now;
    return progress.goes_on(
        std::min(1.0, static_cast<double>(now.evaluations) / static_cast<double>(now.expected)));
  });
}

/// Interrupted where it was.
design::Spectrum watched(const design::SpectrumRequest& request) {
  Progress progress([](double done, double) { return fmt::format("{:.0f} %", 100 * done); }, 1);
  design::Spectrum result =
      design::spectrum(request, [&](double done) { return progress.goes_on(done); });
  if (Progress::interrupted()) {
    throw Interrupted("interrupted: nothing is written");
  }
  return result;
}

}  // namespace

report::DesignReport design_report(const Settings& settings) {
  require_options_for(settings, DesignFor::hit);
  DesignInput input = design_input(settings);
  const std::optional<double> width = notch_width(settings, input.physical);
  require_valid(Oscillator{input.request.problem.p}, Surface{width, {}});
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
  if (width && report.result.finding) {
    design::DesignRequest shown = report.result.request;
    if (const auto& check = report.result.finding->pulse) {
      shown.pulse = check->pulse;
      shown.problem.p = check->p;
    }
    report.built_notch = built_notch(shown, report.result.finding->point, *width);
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

namespace {

ExitCode run_design(const Settings& settings, Output& output) {
  const auto show = [&](const auto& report) {
    finish(report, Command::design, settings, output);
    return exit_code(report.result);
  };
  if (designs_under_records(settings)) {
    const report::RecordDesignInput input = record_design_input(settings);
    return show(report::RecordDesignReport{watched(input), input.physical});
  }
  return show(design_report(settings));
}

ExitCode run_region(const Settings& settings, Output& output) {
  const report::RegionReport report = region_report(settings);
  finish(report, Command::region, settings, output);
  return report.answer.region.feasible ? exit_done : exit_infeasible;
}

ExitCode run_simulate(const Settings& settings, Output& output) {
  const SimulateInput input = simulate_input(settings);
  const report::MotionReport report{input.request, watched(input.request), input.record,
                                    input.physical};
  if (const std::string locked = report::lock_sentence(report); !locked.empty()) {
    remark(locked);
  }
  const std::optional<std::string>& trajectory = input.trajectory;
  if (trajectory) {
    const std::string rows = report::trajectory_csv(report.answer.trajectory, report.physical);
    if (*trajectory == "-") {
      output.print(rows);
    } else {
      output.write_file("trajectory", *trajectory, rows);
    }
  }
  finish(report, Command::simulate, settings, output, trajectory != "-");
  return exit_done;
}

ExitCode run_spectrum(const Settings& settings, Output& output) {
  const auto table = settings.text("table");
  if (table == "-" && settings.flag("json")) {
    throw UsageError("json and the table would both go to standard output: give --table FILE");
  }
  report::SpectrumReport report = spectrum_input(settings);
  report.result = watched(report.result.request);
  if (table == "-") {
    output.print(report::spectrum_csv(report));
  } else if (table) {
    output.write_file(
        "table", *table,
        table->ends_with(".npy") ? report::spectrum_npy(report) : report::spectrum_csv(report));
  }
  finish(report, Command::spectrum, settings, output, table != "-");
  return exit_done;
}

}  // namespace

ExitCode run(Command command, const Settings& settings, Output& output) {
  static const std::map<Command, ExitCode (*)(const Settings&, Output&)> runners{
      {Command::design, run_design},     {Command::region, run_region},
      {Command::simulate, run_simulate}, {Command::spectrum, run_spectrum},
      {Command::sweep, run_sweep},       {Command::accuracy, run_accuracy}};
  return runners.at(command)(settings, output);
}

}  // namespace stillpoint::cli
