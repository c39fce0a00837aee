// SPDX-License-Identifier: MIT
#pragma once

#include "record_lines.hpp"
#include "record_units.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace stillpoint::records {

/// The head of a PEER .AT2 file: titles, a line that names the quantity and its units, and last the
/// line that holds NPTS and DT. That line is the fourth or the seventh of most files.
struct At2Header {
  std::size_t count{0};     ///< NPTS
  double step{0};           ///< DT in s
  std::size_t line{0};      ///< where both stand
  std::string description;  ///< the titles
  std::optional<RecordUnits> units;
  std::size_t units_line{0};
};

/// The line with NPTS must be one of so many; comments (#) do not count as such a line.
constexpr std::size_t longest_at2_header = 32;

/// Whether an AT2 header comes next.
[[nodiscard]] bool has_at2_header(RecordLines lines);

/// Reads it, and leaves `lines` at its last line.
[[nodiscard]] At2Header read_at2_header(RecordLines& lines);

}  // namespace stillpoint::records
