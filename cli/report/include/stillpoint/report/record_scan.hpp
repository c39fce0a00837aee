// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/record_design.hpp>
#include <stillpoint/report/document.hpp>
#include <stillpoint/sweep/output.hpp>
#include <stillpoint/sweep/part_label.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace stillpoint::report {

/// A part of the scan of a design under records, with which the search begins; the search needs all
/// parts. The entries are the dampers of the scan.
struct RecordScan {
  sweep::PartLabel label;
  std::vector<design::SuiteFigures> figures;
};

/// How much of the scan it is.
[[nodiscard]] Document document(const RecordScan& scan);
/// Reads back to the same numbers.
[[nodiscard]] nlohmann::ordered_json json(const RecordScan& scan);

/// Whether the file begins as such a part does.
[[nodiscard]] bool is_record_scan(const std::string& path);

/// Throws records::FileError if the file is not a complete part.
[[nodiscard]] RecordScan read_record_scan(const std::string& path);

/// The part `wanted`, if its file is there already. Throws LeftoverError for another part of the
/// same design.
[[nodiscard]] std::optional<RecordScan> find_record_scan(const sweep::PartLabel& wanted);

struct RecordPart {
  RecordScan scan;
  bool computed{true};  ///< not found in its file
};

/// The part `wanted` of the scan of a design; with `resume`, the one in its file if that is
/// complete. Empty if `ask` ended it. Throws InputError, and LeftoverError as above.
[[nodiscard]] std::optional<RecordPart> record_part(const sweep::PartLabel& wanted,
                                                    const design::RecordDesignRequest& request,
                                                    bool resume, const design::RecordWatch& ask);

/// What its file holds.
[[nodiscard]] std::string text(const RecordScan& scan);

/// Writes it to its file, if it has one that does not contain it already.
void write(const RecordPart& part, sweep::Output& output);

/// The whole scan, from all its parts in any order. Throws as sweep::merge does.
[[nodiscard]] RecordScan merged_record_scan(const std::vector<std::string>& parts);

}  // namespace stillpoint::report
