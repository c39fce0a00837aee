// SPDX-License-Identifier: MIT
#pragma once

#include "record_lines.hpp"

#include <cstddef>
#include <string_view>

namespace stillpoint::records {

struct At2Counts {
  std::size_t count{0};  ///< NPTS
  double step{0};        ///< DT in s
};

/// Whether NPTS stands in a line, as a word of its own.
[[nodiscard]] bool has_npts(std::string_view line);

/// The line with NPTS and DT, in one of the forms
///
///     NPTS= 2000, DT= .02000 SEC        4096    0.0100    NPTS, DT
///
/// in either case, with or without SEC. Refuses what is missing or out of bounds.
[[nodiscard]] At2Counts read_at2_counts(const RecordLines& lines);

}  // namespace stillpoint::records
