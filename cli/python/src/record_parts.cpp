// SPDX-License-Identifier: MIT
// Designs under records in parts: what is one, and what all of them make.

#include "record_parts.hpp"

#include "input/request.hpp"
#include "interruptible.hpp"
#include "output.hpp"
#include "written_files.hpp"

#include <stillpoint/sweep/part.hpp>

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace stillpoint::python {

using cli::Command;

namespace {

class DesignPart final : public Result {
 public:
  explicit DesignPart(report::RecordScan scan) : scan_(std::move(scan)) {}

  [[nodiscard]] nlohmann::ordered_json json() const override { return report::json(scan_); }
  [[nodiscard]] report::Document document() const override {
    report::Document said;
    said.title = fmt::format("Part {} of a design", sweep::text(scan_.label.part));
    said.verdict =
        fmt::format("{} of {} dampers.", scan_.figures.size(), scan_.label.whole.entries);
    return said;
  }
  [[nodiscard]] figures::HtmlPage page() const override { return page_without_figures(); }

 private:
  report::RecordScan scan_;
};

}  // namespace

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
  return std::make_unique<DesignPart>(found->scan);
}

std::unique_ptr<Result> merged_design(const std::vector<std::string>& parts) {
  return std::make_unique<Answered>(interruptible([&](const std::stop_token& stop) {
    const report::RecordScan scan = report::merged_record_scan(parts);
    const report::RecordDesignInput input =
        record_design_input(cli::record_design_settings(scan.label.task), scan);
    return answers::answer_of(report::RecordDesignReport{
        design::design(input.request, scan.figures,
                       [&](const auto& /*progress*/) { return !stop.stop_requested(); }),
        input.physical});
  }));
}

}  // namespace stillpoint::python
