// SPDX-License-Identifier: MIT
#pragma once

#include "line_reader.hpp"

#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// The fields of a line of CSV, the last one of `lines`, without blanks and quotes. A field may be
/// in double quotes, and then a comma between them belongs to it (RFC 4180). Throws FileError if a
/// quote is opened and not closed.
[[nodiscard]] std::vector<std::string_view> csv_fields(std::string_view line,
                                                       const LineReader& lines);

}  // namespace stillpoint::sweep
