// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "input/request.hpp"
#include "messages.hpp"
#include "progress.hpp"

#include <stillpoint/design/motion_findings.hpp>

namespace stillpoint::cli {

namespace {

/// Warns beforehand if the motion takes minutes, which needs a raised limit.
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
      remark(fmt::format("up to {:.3g} half-cycles: this may take about {:.3g} minutes",
                         *excess.bound(), minutes));
    }
  }
  request.half_cycle_limit = limit;
  return simulate(request);
}

/// A forced run can be interrupted; a free one has a limit.
Simulation watched(const SimulationRequest& request) {
  if (!is_forced(request)) {
    return free_simulation(request);
  }
  // Without t_end the load's own end is known; what the mass does after it takes no time to
  // compute.
  const double end = request.t_end.value_or(duration(request.excitation).value_or(0));
  Progress progress(
      [end](double tau, double) { return report::progress_in_tau(tau, tau <= end ? end : 0); },
      end);
  double reached = 0;
  Simulation answer = simulate(request, [&](double tau) {
    reached = tau;
    if (!request.samples) {  // a trajectory exceeds its limit before it takes minutes
      progress.announce_minutes(tau);
    }
    return progress.goes_on(tau);
  });
  if (Progress::interrupted()) {
    throw Interrupted(fmt::format("interrupted at tau = {:.6g}, nothing is written", reached));
  }
  return answer;
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

/// Ends with what was found where it is interrupted.
report::RecordDesignReport watched(const report::RecordDesignInput& input) {
  design::RecordProgress last;
  Progress progress([&](double, double) { return report::progress_words(last, input.physical); },
                    1);
  const auto show = [&](const design::RecordProgress& now) {
    last = now;
    return progress.goes_on(
        std::min(1.0, static_cast<double>(now.evaluations) / static_cast<double>(now.expected)));
  };
  return {design::design(input.request, show), input};
}

template <Command command>
ExitCode run_dampers(const Settings& settings, Output& output) {
  return answer_dampers(
      settings, command, [](const report::RecordDesignInput& input) { return watched(input); },
      [&](const auto& report) { return finish(report, command, settings, output); });
}

/// The file that the option gives its rows, or "-" for them instead of the report; empty for none.
std::optional<std::string> rows_to(std::string_view option, const Settings& settings) {
  auto path = settings.text(option);
  if (path == "-") {
    require_no_json(settings, option, option);
  }
  return path;
}

void put_rows(std::string_view option, const std::string& path, const std::string& rows,
              Output& output) {
  if (path == "-") {
    output.print(rows);
  } else {
    output.write_file(option, path, rows);
  }
}

ExitCode run_simulate(const Settings& settings, Output& output) {
  const auto trajectory = rows_to("trajectory", settings);
  report::MotionReport report = simulate_input(settings);
  report.answer = watched(report.request);
  report.findings = design::findings_of(report.request, report.answer);
  if (trajectory) {
    put_rows("trajectory", *trajectory,
             report::trajectory_csv(report.answer.trajectory, report.physical), output);
  }
  return finish(report, Command::simulate, settings, output, trajectory != "-");
}

ExitCode run_spectrum(const Settings& settings, Output& output) {
  const auto table = rows_to("table", settings);
  report::SpectrumReport report = spectrum_input(settings);
  report.result = watched(report.result.request);
  if (table) {
    put_rows("table", *table, report::spectrum_rows(report, table->ends_with(".npy")), output);
  }
  return finish(report, Command::spectrum, settings, output, table != "-");
}

}  // namespace

ExitCode run(Command command, const Settings& settings, Output& output) {
  static const std::map<Command, ExitCode (*)(const Settings&, Output&)> runners{
      {Command::design, run_dampers<Command::design>},
      {Command::region, run_dampers<Command::region>},
      {Command::simulate, run_simulate},
      {Command::spectrum, run_spectrum},
      {Command::sweep, run_sweep},
      {Command::accuracy, run_accuracy}};
  return runners.at(command)(settings, output);
}

}  // namespace stillpoint::cli
