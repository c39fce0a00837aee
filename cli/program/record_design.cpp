// SPDX-License-Identifier: MIT
// A design under records, at once or in parts: the scan is split, and the searches that begin with
// all of it run where the parts are joined.

#include "commands.hpp"
#include "input/request.hpp"
#include "messages.hpp"
#include "progress.hpp"
#include "written_files.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/report/progress_words.hpp>
#include <stillpoint/report/record_design.hpp>
#include <stillpoint/report/record_scan.hpp>
#include <stillpoint/sweep/files_apart.hpp>
#include <stillpoint/sweep/merge.hpp>
#include <stillpoint/sweep/part.hpp>

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
  remark(report::lock_sentence(report));
  return finish(report, Command::design, settings, output);
}

ExitCode run_part(const Settings& settings, Output& output) {
  if (wants_page(settings)) {
    throw UsageError("part and a page exclude each other: design merge writes the page");
  }
  const report::RecordDesignInput input = record_design_input(settings);
  const std::int64_t dampers = design::scan_size(input.request);
  const auto path = settings.text("output");
  report::RecordScan scan{{path.value_or(""),
                           sweep::parse_part(*settings.text("part")),
                           record_design_identity(settings, input.request),
                           {dampers, 0}},
                          {}};
  const auto [first, count] = range_of(scan.label.part, dampers);
  auto found = path ? report::find_record_scan(scan.label) : std::nullopt;
  const bool computed = !found || !settings.flag("resume");
  if (computed) {
    scan.figures = watched(input, [&, first = first, count = count](const auto& ask) {
      return design::scan_part(input.request, first, count, ask);
    });
    if (std::ssize(scan.figures) < count) {
      throw Interrupted("interrupted: nothing is written");
    }
  } else {
    scan = *std::move(found);
  }
  const std::string written = json(scan).dump() + "\n";
  if (path && computed) {
    output.write_file("output", *path, written);
  }
  output.print(path && !settings.flag("json")
                   ? fmt::format("{}: {} of {} dampers\n", *path, count, dampers)
                   : written);
  return exit_done;
}

}  // namespace

ExitCode run_record_design(const Settings& settings, Output& output) {
  if (settings.has("part")) {
    return run_part(settings, output);
  }
  if (settings.flag("resume")) {
    throw UsageError("resume is for a part of a design: give --part as well");
  }
  const report::RecordDesignInput input = record_design_input(settings);
  return show({watched(input, [&](const auto& ask) { return design::design(input.request, ask); }),
               input.physical},
              settings, output);
}

ExitCode run_design_merge(const MergeFiles& files, const Settings& shown, Output& output) {
  sweep::require_apart({"output", files.output}, files.parts);
  const report::RecordScan scan = report::merged_record_scan(files.parts);
  Settings settings = record_design_settings(scan.label.task);
  settings.complete_with(shown);
  settings.set(*find_option("output"), files.output);
  require_files_apart(Command::design, settings, std::nullopt);
  if (const auto page = settings.text("html")) {
    sweep::require_apart({"html", *page}, files.parts);
  }
  const report::RecordDesignInput input = record_design_input(settings);
  sweep::PartLabel now = scan.label;
  now.task = record_design_identity(settings, input.request);
  if (const std::string differs = difference(scan.label, now); !differs.empty()) {
    throw records::FileError({.kind = "part", .path = scan.label.path},
                             "was made of other records, or by another version: " + differs);
  }
  return show(
      {watched(input,
               [&](const auto& ask) { return design::design(input.request, scan.figures, ask); }),
       input.physical},
      settings, output);
}

}  // namespace stillpoint::cli
