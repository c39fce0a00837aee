// SPDX-License-Identifier: MIT
#pragma once

#include "line_reader.hpp"

#include <stillpoint/records/csv.hpp>

#include <span>
#include <string>
#include <string_view>

namespace stillpoint::sweep {

/// The fields of the row that begins with `line`, the last one of `lines`, which gives the lines in
/// which a quoted field goes on. They are in `row`, until its next use. Throws FileError for a
/// wrong row.
[[nodiscard]] std::span<const std::string> csv_fields(std::string_view line, LineReader& lines,
                                                      records::CsvRow& row);

}  // namespace stillpoint::sweep
