// SPDX-License-Identifier: MIT
// A design under records, at once or in parts: the scan is split, and the searches that begin with
// all of it run where the parts are joined.

#include "commands.hpp"
#include "input/request.hpp"
#include "messages.hpp"
#include "progress.hpp"
#include "written_files.hpp"

#include <stillpoint/report/progress_words.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/record_scan.hpp>
#include <stillpoint/sweep/merge.hpp>
#include <stillpoint/sweep/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::cli {

namespace {

/// work(ask), with its progress shown; an interrupt ends it.
template <class Work>
auto watched(const report::RecordDesignInput& input, const Work& work) {
  design::RecordProgress last;
  Progress progress([&](double, double) { return report::progress_words(last, input.physical); },
                    1);
  return work([&](const design::RecordProgress& now) {
    last = now;
    return progress.goes_on(
        std::min(1.0, static_cast<double>(now.evaluations) / static_cast<double>(now.expected)));
  });
}

ExitCode show(const report::RecordDesignReport& report, const Settings& settings, Output& output) {
  remark(report::notch_sentence(report));
  remark(report::lock_sentence(report));
  return finish(report, Command::design, settings, output);
}

ExitCode run_part(const Settings& settings, Output& output) {
  const report::RecordDesignInput input = record_design_input(settings);
  const sweep::PartLabel wanted = record_part_label(settings, input.request);
  const auto found = watched(input, [&](const auto& ask) {
    return report::record_part(wanted, input.request, settings.flag("resume"), ask);
  });
  if (!found) {
    throw Interrupted("interrupted: nothing is written");
  }
  write(*found, output);
  const auto& [label, figures] = found->scan;
  output.print(
      label.path.empty() || settings.flag("json")
          ? text(found->scan)
          : fmt::format("{}: {} of {} dampers\n", label.path, figures.size(), label.whole.entries));
  return exit_done;
}

}  // namespace

ExitCode run_record_design(const Settings& settings, Output& output) {
  if (settings.has("part")) {
    return run_part(settings, output);
  }
  const report::RecordDesignInput input = record_design_input(settings);
  return show(
      report::record_design_report(
          watched(input, [&](const auto& ask) { return design::design(input.request, ask); }),
          input.physical),
      settings, output);
}

ExitCode run_design_merge(const MergeFiles& files, const Settings& shown, Output& output) {
  sweep::require_apart({"output", files.output}, files.parts);
  const report::RecordScan scan = report::merged_record_scan(files.parts);
  Settings settings = record_design_settings(scan.label.task);
  settings.complete_with(shown);
  settings.set("output", files.output);
  require_files_apart(Command::design, settings, std::nullopt);
  if (const auto page = settings.text("html")) {
    sweep::require_apart({"html", *page}, files.parts);
  }
  const report::RecordDesignInput input = record_design_input(settings, scan);
  return show(report::record_design_report(watched(input,
                                                   [&](const auto& ask) {
                                                     return design::design(input.request,
                                                                           scan.figures, ask);
                                                   }),
                                           input.physical),
              settings, output);
}

}  // namespace stillpoint::cli
