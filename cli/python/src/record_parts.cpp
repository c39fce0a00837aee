// SPDX-License-Identifier: MIT
// Designs under records in parts: what is one, and what all of them make.

#include "record_parts.hpp"

#include "input/request.hpp"
#include "interruptible.hpp"
#include "output.hpp"
#include "written_files.hpp"

#include <string>
#include <vector>

namespace stillpoint::python {

using cli::Command;

std::unique_ptr<Result> design_part(cli::Settings settings) {
  cli::resolve_part(settings);
  cli::require_files_apart(Command::design, settings, std::nullopt);
  const auto found = interruptible([&](const std::stop_token& stop) {
    const report::RecordDesignInput input = cli::record_design_input(settings);
    return report::record_part(cli::record_part_label(settings, input.request), input.request,
                               settings.flag("resume"),
                               [&](const auto& /*progress*/) { return !stop.stop_requested(); });
  });
  cli::Output output;
  write(*found, output);
  output.commit();
  return std::make_unique<Result>(answers::answer_of(found->scan));
}

std::unique_ptr<Result> merged_design(const std::vector<std::string>& parts) {
  return std::make_unique<Result>(interruptible([&](const std::stop_token& stop) {
    const report::RecordScan scan = report::merged_record_scan(parts);
    const report::RecordDesignInput input =
        record_design_input(cli::record_design_settings(scan.label.task), scan);
    return answers::answer_of(report::record_design_report(
        design::design(input.request, scan.figures,
                       [&](const auto& /*progress*/) { return !stop.stop_requested(); }),
        input.physical));
  }));
}

}  // namespace stillpoint::python
