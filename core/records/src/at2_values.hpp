// SPDX-License-Identifier: MIT
#pragma once

#include "at2_header.hpp"
#include "record_lines.hpp"
#include "record_scale.hpp"

#include <vector>

namespace stillpoint::records {

/// The values behind an AT2 header, any number of them in a line. There must be as many as the
/// header says. Blank lines and text may follow.
[[nodiscard]] std::vector<double> read_at2_values(RecordLines& lines, const At2Header& header,
                                                  const RecordScale& scale);

}  // namespace stillpoint::records
