// SPDX-License-Identifier: MIT
#include "fuzz.hpp"

#include "commands.hpp"
#include "input/request.hpp"
#include "options/scene.hpp"
#include "output.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/design/motion_findings.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/reduction.hpp>
#include <stillpoint/report/spectrum.hpp>
#include <stillpoint/report/sweep.hpp>
#include <stillpoint/sweep/run.hpp>

#include <algorithm>
#include <utility>

// Scenes: the first line is the command, the rest is the scene. It is read as the program reads it,
// up to the checked request; that is computed where it is small, and reported in every form.

namespace {

using namespace stillpoint;
using namespace stillpoint::fuzz;
using namespace stillpoint::cli;

// The limits of a scene here, so that an execution takes a few milliseconds.
constexpr double most_half_cycles = 1000;
constexpr std::int64_t most_samples = 50;
constexpr std::int64_t most_entries = 30;
constexpr std::int64_t most_arrivals = 6;
constexpr std::int64_t most_trade_offs = 3;
constexpr double longest_forced_sweep = 1e3;  // in radians

/// In place of each file that a scene reads. It writes none, as nothing here does.
void name_files(Settings& settings) {
  static const MemoryFile record, list, parts, entries;
  record.hold("0 0\n0.5 0.2\n1 -0.3\n1.5 0.1\n");
  list.hold(fmt::format("file,scale\n{},2\n", record.path()));
  parts.hold("name,f,delta_m\nA,0.2,0.3\nB,0.1,0.001\n");
  entries.hold("v0,f,delta\n1,0.1,0.2\n1,0.3,0.1\n");
  for (const auto& [name, file] : {std::pair{"record", &record}, std::pair{"records-list", &list},
                                   std::pair{"catalogue", &parts}, std::pair{"list", &entries}}) {
    if (settings.has(name)) {
      settings.set(name, file->path());
    }
  }
}

/// A count that is right is lowered; one that is wrong is refused as it is.
void lower(Settings& settings, std::string_view name, std::int64_t most) {
  constexpr std::int64_t right = 1000;
  if (const auto count = settings.integer(name); count && *count > most && *count <= right) {
    settings.set(name, most);
  }
}

/// In the form that is asked for.
template <class Report>
void show(const Report& report, const Settings& settings) {
  if (wants_page(settings)) {
    static_cast<void>(html(page(report)));
  } else if (settings.flag("json")) {
    static_cast<void>(json(report).dump());
  } else {
    static_cast<void>(shown(report, settings));
  }
}

void run_design(Settings settings) {
  if (takes_cases(settings)) {
    static_cast<void>(record_design_input(settings, Command::design));  // its search takes seconds
    return;
  }
  if (settings.has("pulse")) {
    static_cast<void>(design_input(settings));  // the same
    return;
  }
  lower(settings, "arrivals", most_arrivals);
  lower(settings, "trade-off", most_trade_offs);
  show(answers::answer(design_input(settings)), settings);
}

void run_region(Settings settings) {
  if (takes_cases(settings)) {
    static_cast<void>(record_design_input(settings, Command::region));
    return;
  }
  lower(settings, "arrivals", most_arrivals);
  show(answers::answer(region_input(settings)), settings);
}

void run_simulate(const Settings& settings) {
  report::MotionReport report = simulate_input(settings);
  SimulationRequest& request = report.request;
  request.half_cycle_limit =
      std::min(request.half_cycle_limit.value_or(HUGE_VAL), most_half_cycles);
  if (request.samples) {
    request.samples = std::min(*request.samples, most_samples);
  }
  int calls = 0;
  report.answer = simulate(request, [&calls](double) { return ++calls < 3; });
  if (!report.answer.cancelled) {
    report.findings = design::findings_of(request, report.answer);
    static_cast<void>(report::trajectory_csv(report.answer.trajectory, report.physical));
    show(report, settings);
  }
}

void run_spectrum(const Settings& settings) {
  report::SpectrumReport report = spectrum_input(settings);
  design::SpectrumRequest& request = report.result.request;
  if (request.p.size() <= static_cast<std::size_t>(most_entries)) {
    request.threads = 1;
    report.result = design::spectrum(request);
    show(report, settings);
  }
}

/// Whether the entries of a sweep are few, and each of them is short: it cannot be stopped within
/// one.
bool is_small(const sweep::SweepSpec& spec) {
  double fastest = 1;
  double slowest = 1;
  for (const auto& [quantity, axis] : spec.axes) {
    const auto [least, most] = axis.ends();
    if (quantity == sweep::Quantity::p || quantity == sweep::Quantity::lambda) {
      fastest = std::max(fastest, most);
      slowest = std::min(slowest, least);
    }
    if (quantity == sweep::Quantity::arrivals && most > most_arrivals) {
      return false;
    }
  }
  if (spec.pulse || own_entries(spec).count.value_or(0) > most_entries) {
    return false;
  }
  return spec.kind != sweep::SweepKind::forced ||
         std::max(spec.t_end.value_or(0), 1 / slowest) * fastest < longest_forced_sweep;
}

void compute(report::SweepReport report, const Settings& settings) {
  const sweep::SweepSpec& spec = report.spec;
  sweep::RowSink rows;
  if (spec.reduction) {
    const auto reduced = report::reduction_report(spec, sweep::run(spec, rows));
    static_cast<void>(settings.flag("json") ? json(reduced).dump() : shown(reduced, settings));
    return;
  }
  if (wants_page(settings)) {
    report.map.emplace(spec);
  }
  report.summary = sweep::run(spec, rows, {{}, {}, report.map ? &*report.map : nullptr});
  static_cast<void>(report.map ? html(page(report))
                               : json(report).dump() + shown(report, settings));
}

void run_sweep(Settings settings) {
  resolve_part(settings);
  sweep::SweepSpec spec = sweep_request(settings);
  if (!is_small(spec)) {
    return;
  }
  spec.threads = 1;
  spec.half_cycle_limit = std::min(spec.half_cycle_limit.value_or(HUGE_VAL), most_half_cycles);
  try {
    compute({std::move(spec)}, settings);
  } catch (const EntryError& error) {
    require_short(error.what());
  }
}

void run(Command command, const Settings& settings) {
  switch (command) {
    case Command::design:
      return run_design(settings);
    case Command::region:
      return run_region(settings);
    case Command::simulate:
      return run_simulate(settings);
    case Command::spectrum:
      return run_spectrum(settings);
    case Command::sweep:
      return run_sweep(settings);
    case Command::accuracy:  // in 50 digits
    case Command::init:
    case Command::explore:
      return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text = text_of(data, size);
  const auto command = parse<Command>(take(text, '\n'));
  if (!command) {
    return -1;  // not worth a place in the corpus
  }
  accepted<UsageError>([&] {
    Settings scene = parse_scene(text, "input", *command);
    Settings settings = scene_and_flags(*command, {}, scene);
    name_files(settings);
    ::run(*command, settings);
    for (const std::string& doubt : doubts(settings, *command, {})) {
      require_short(doubt);
    }
  });
  return 0;
}
