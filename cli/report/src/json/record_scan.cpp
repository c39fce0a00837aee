// SPDX-License-Identifier: MIT
#include <stillpoint/report/record_scan.hpp>

#include "json/part_files.hpp"
#include "json/parts.hpp"

#include <stillpoint/sweep/json_text.hpp>

#include <array>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace stillpoint::report {

namespace {

using design::SuiteFigures;
using nlohmann::ordered_json;

constexpr auto record_scan_schema = "stillpoint/record-scan/1";
constexpr std::array<std::pair<const char*, double SuiteFigures::*>, 4> scan_columns{
    {{"peak_amplitude", &SuiteFigures::peak},
     {"peak_absolute_acceleration", &SuiteFigures::acceleration},
     {"residual", &SuiteFigures::residual},
     {"decision_margin", &SuiteFigures::margin}}};

RecordScan record_scan_from(const ordered_json& document) {
  RecordScan scan;
  sweep::read_integers(document.at("dampers"), scan.label.whole.entries);
  const ordered_json& columns = document.at("figures");
  scan.figures.resize(columns.at(scan_columns.front().first).size());
  for (const auto& [column, member] : scan_columns) {
    const ordered_json& values = columns.at(column);
    for (std::size_t i = 0; i < scan.figures.size(); ++i) {
      const ordered_json& value = values.at(i);
      if (value.is_null()) {
        scan.figures[i].settled = false;
      } else {
        value.get_to(scan.figures[i].*member);
      }
    }
  }
  return scan;
}

}  // namespace

Document document(const RecordScan& scan) {
  Document document;
  document.title = fmt::format("Part {} of a design", sweep::text(scan.label.part));
  document.verdict =
      fmt::format("{} of {} dampers.", scan.figures.size(), scan.label.whole.entries);
  return document;
}

ordered_json json(const RecordScan& scan) {
  ordered_json columns;
  for (const auto& [column, member] : scan_columns) {
    ordered_json& values = columns[column] = ordered_json::array();
    for (const SuiteFigures& figures : scan.figures) {
      values.push_back(figures.settled ? ordered_json(figures.*member) : nullptr);
    }
  }
  const auto& [path, part, task, whole] = scan.label;
  ordered_json result{{"schema", record_scan_schema},
                      {"program", program_json()},
                      {"part", {{"number", part.number}, {"count", part.count}}},
                      {"dampers", whole.entries},
                      {"figures", std::move(columns)},
                      {"task", ordered_json::parse(task)}};
  result["digest"] = digest_json(result);
  return result;
}

bool is_record_scan(const std::string& path) {
  constexpr std::size_t most = 100;
  std::string beginning(most, ' ');
  std::ifstream(path, std::ios::binary).read(beginning.data(), most);
  return beginning.find(record_scan_schema) != std::string::npos;
}

RecordScan read_record_scan(const std::string& path) {
  return read_part(path, record_scan_schema, "a design under records", record_scan_from,
                   [](const RecordScan& scan) { return std::ssize(scan.figures); });
}

std::optional<RecordScan> find_record_scan(const sweep::PartLabel& wanted) {
  return sweep::find_part(wanted, "design", read_record_scan);
}

RecordScan merged_record_scan(const std::vector<std::string>& parts) {
  sweep::PartOrder order("design");
  std::vector<RecordScan> scans;
  scans.reserve(parts.size());
  for (const std::string& path : parts) {
    order.add(scans.emplace_back(read_record_scan(path)).label);
  }
  RecordScan all{scans.front().label, {}};
  all.figures.reserve(static_cast<std::size_t>(all.label.whole.entries));
  for (const std::size_t place : order.places()) {
    const std::vector<SuiteFigures>& figures = scans[place].figures;
    all.figures.insert(all.figures.end(), figures.begin(), figures.end());
  }
  return all;
}

std::optional<RecordPart> record_part(const sweep::PartLabel& wanted,
                                      const design::RecordDesignRequest& request, bool resume,
                                      const design::RecordWatch& ask) {
  auto found = wanted.path.empty() ? std::nullopt : find_record_scan(wanted);
  if (found && resume) {
    return RecordPart{*std::move(found), false};
  }
  const auto [first, count] = range_of(wanted.part, design::scan_size(request));
  RecordScan scan{wanted, design::scan_part(request, first, count, ask)};
  return std::ssize(scan.figures) < count ? std::nullopt
                                          : std::optional(RecordPart{std::move(scan)});
}

std::string text(const RecordScan& scan) {
  return json(scan).dump() + "\n";
}

void write(const RecordPart& part, sweep::Output& output) {
  if (const std::string& path = part.scan.label.path; part.computed && !path.empty()) {
    output.write_file("output", path, text(part.scan));
  }
}

}  // namespace stillpoint::report
