// SPDX-License-Identifier: MIT
#include "commands.hpp"

#include "messages.hpp"
#include "pages.hpp"
#include "progress.hpp"
#include "record_design_input.hpp"
#include "request.hpp"
#include "surface_input.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace stillpoint::cli {

namespace {

/// The page where it was asked for.
template <class Report>
void write_page_of(const Report& report, Command command, const Settings& settings,
                   Output& output) {
  if (wants_page(settings)) {
    write_page(settings, command, page(report), output);
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
  Progress progress(progress_in_tau(end), end);
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

}  // namespace

report::RecordDesignReport record_design_report(const Settings& settings) {
  const report::RecordDesignInput input = record_design_input(settings);
  return {watched(input), input.physical};
}

report::DesignReport design_report(const Settings& settings) {
  require_no_record_options(settings);
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

ExitCode run_design(const Settings& settings, Output& output) {
  const auto show = [&](const auto& report) {
    write_page_of(report, Command::design, settings, output);
    print_report(report, settings, output);
    return exit_code(report.result);
  };
  return designs_under_records(settings) ? show(record_design_report(settings))
                                         : show(design_report(settings));
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

ExitCode run_region(const Settings& settings, Output& output) {
  const report::RegionReport report = region_report(settings);
  write_page_of(report, Command::region, settings, output);
  print_report(report, settings, output);
  return report.answer.region.feasible ? exit_done : exit_infeasible;
}

report::MotionReport motion_report(const Settings& settings) {
  SimulateInput input = simulate_input(settings);
  Simulation answer = watched(input.request);
  return {std::move(input.request), std::move(answer), input.record, input.physical};
}

ExitCode run_simulate(const Settings& settings, Output& output) {
  const report::MotionReport report = motion_report(settings);
  if (const std::string locked = report::lock_sentence(report); !locked.empty()) {
    remark(locked);
  }
  const auto trajectory = settings.text("trajectory");
  if (trajectory) {
    const std::string rows = report::trajectory_csv(report.answer.trajectory, report.physical);
    if (*trajectory == "-") {
      output.print(rows);
    } else {
      output.write_file("trajectory", *trajectory, rows);
    }
  }
  write_page_of(report, Command::simulate, settings, output);
  print_report(report, settings, output, trajectory != "-");
  return exit_done;
}

}  // namespace stillpoint::cli
