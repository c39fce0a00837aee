// SPDX-License-Identifier: MIT
#include "record_part.hpp"

#include "input/request.hpp"

#include <stillpoint/sweep/part.hpp>

#include <iterator>
#include <utility>

namespace stillpoint::cli {

std::optional<RecordPart> record_part(const Settings& settings,
                                      const report::RecordDesignInput& input,
                                      const design::RecordWatch& ask) {
  const std::int64_t dampers = design::scan_size(input.request);
  const auto path = settings.text("output");
  report::RecordScan scan{{path.value_or(""),
                           sweep::parse_part(*settings.text("part")),
                           record_design_identity(settings, input.request),
                           {dampers, 0}},
                          {}};
  if (auto found = path ? report::find_record_scan(scan.label) : std::nullopt;
      found && settings.flag("resume")) {
    return RecordPart{*std::move(found), false};
  }
  const auto [first, count] = range_of(scan.label.part, dampers);
  scan.figures = design::scan_part(input.request, first, count, ask);
  if (std::ssize(scan.figures) < count) {
    return std::nullopt;
  }
  return RecordPart{std::move(scan)};
}

std::string text(const report::RecordScan& scan) {
  return json(scan).dump() + "\n";
}

void write(const RecordPart& part, sweep::Output& output) {
  if (const std::string& path = part.scan.label.path; part.computed && !path.empty()) {
    output.write_file("output", path, text(part.scan));
  }
}

}  // namespace stillpoint::cli
