// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/record_design.hpp>
#include <stillpoint/sweep/part_label.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::report {

/// A part of the scan of a design under records: what a search, which sees all of them, begins
/// with. The entries are the dampers of the scan.
struct RecordScan {
  sweep::PartLabel label;
  std::vector<design::SuiteFigures> figures;
};

/// Reads back to the same numbers.
[[nodiscard]] nlohmann::ordered_json json(const RecordScan& scan);

/// Throws records::FileError if the file is not a whole part.
[[nodiscard]] RecordScan read_record_scan(const std::string& path);

/// The part `wanted`, if its file is there already. Throws LeftoverError for another part of the
/// same design.
[[nodiscard]] std::optional<RecordScan> find_record_scan(const sweep::PartLabel& wanted);

/// The whole scan, from all its parts in any order. Throws as sweep::merge does.
[[nodiscard]] RecordScan merged_record_scan(const std::vector<std::string>& parts);

}  // namespace stillpoint::report
