// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "input/request.hpp"
#include "messages.hpp"
#include "progress.hpp"

#include <stillpoint/report/reduction.hpp>
#include <stillpoint/report/sweep.hpp>
#include <stillpoint/sweep/merge.hpp>
#include <stillpoint/sweep/open_rows.hpp>

namespace stillpoint::cli {

namespace {

using sweep::SweepEnd;
using sweep::SweepSpec;
using sweep::SweepSummary;

/// What the user can do about an error, given what is `left`.
std::string advice(const std::exception& error, const sweep::LeftRows& left) {
  const auto* const file = dynamic_cast<const records::FileError*>(&error);
  if (file == nullptr || !left.file) {
    return "";
  }
  return file->place().kind == "list"
             ? ": correct the list, then give the same command with --resume"
             : ": make room for the rest, then give the same command with --resume";
}

SweepSummary run_watched(const SweepSpec& spec, sweep::RowSink& sink, sweep::SweepMap* map) {
  const auto total = sweep::own_entries(spec).count;
  const std::int64_t begun_with = sink.found().rows;
  Progress progress(
      [&](double rows, double seconds) {
        return report::progress_words(rows, begun_with, total, seconds);
      },
      static_cast<double>(total.value_or(0)), static_cast<double>(begun_with));
  const auto show = [&](const sweep::SweepState& state) {
    const auto rows = static_cast<double>(state.rows);
    progress.announce_minutes(rows);
    static_cast<void>(progress.goes_on(rows));
  };
  try {
    return sweep::run(spec, sink, {progress.stop_token(), show, map});
  } catch (const std::exception& error) {
    const sweep::LeftRows left = sink.leave();
    if (left.count == 0) {
      throw;
    }
    throw UsageError(
        fmt::format("{}; {}{}", words_of(error), description(left), advice(error, left)));
  }
}

void require_complete(const SweepSummary& summary, sweep::RowSink& sink) {
  if (summary.end == SweepEnd::stopped) {
    const sweep::LeftRows left = sink.leave();
    throw Interrupted(
        fmt::format("interrupted: {}{}", description(left),
                    left.file ? ", continue with the same command and --resume" : ""));
  }
  if (summary.end == SweepEnd::stopped_in_map) {
    throw Interrupted("interrupted: the rows are complete, the page is not written");
  }
}

}  // namespace

ExitCode run_sweep(const Settings& settings, Output& output) {
  report::SweepReport report{.spec = sweep_request(settings), .record = settings.text("record")};
  const auto& [spec, summary, map, record] = report;
  const bool rows_on_standard_output = sweep::goes_to_standard_output(spec);
  if (rows_on_standard_output) {
    require_no_json(settings, "rows", "output");
  }
  if (wants_page(settings)) {
    report.map.emplace(spec);
    prepare_page(settings);
  }
  const std::unique_ptr<sweep::RowSink> sink = sweep::open_rows(spec);
  report.summary = run_watched(spec, *sink, map ? &*report.map : nullptr);
  require_complete(summary, *sink);
  if (map) {
    write_page(settings, Command::sweep, page(report), output);
  }
  if (rows_on_standard_output) {
    return exit_done;
  }
  Settings printed = settings;
  if (sweep::keeps_rows(spec)) {
    printed.drop("output");  // which is written
  }
  if (spec.reduction) {
    print_report(report::reduction_report(spec, summary), printed, output);
  } else {
    print_report(report, printed, output);
  }
  return exit_done;
}

ExitCode run_merge(const MergeFiles& files, Output& output) {
  Progress progress([](double bytes, double seconds) {
    return fmt::format("{:.4g} bytes, {:.3g} bytes/s", bytes, bytes / seconds);
  });
  const auto show = [&progress](const sweep::Merged& so_far) {
    static_cast<void>(progress.goes_on(static_cast<double>(so_far.bytes)));
  };
  const sweep::Merged merged =
      sweep::merge(files.output, files.parts, {progress.stop_token(), show});
  if (merged.stopped) {
    throw Interrupted("interrupted: nothing is written");
  }
  if (!merged.whole.state.reduction.row.empty()) {
    output.write_file("output", files.output,
                      report::json_text(json(report::ReductionReport{merged.whole})));
  } else if (!sweep::is_standard_output(files.output)) {
    output.print(fmt::format("{}: {} rows of {} parts\n", files.output, merged.whole.state.rows,
                             files.parts.size()));
  }
  return exit_done;
}

}  // namespace stillpoint::cli
