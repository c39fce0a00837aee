// SPDX-License-Identifier: MIT
#pragma once

#include "channel.hpp"

#include <optional>
#include <string_view>

namespace stillpoint::records {

// The lines of an AT2 header that carry information.

struct At2Counts {
  HeaderText count;  ///< NPTS
  HeaderText step;   ///< DT in s
};

/// Whether a line has NPTS as a separate word.
[[nodiscard]] bool has_npts(std::string_view line);

/// The line with NPTS and DT, in one of the forms
///
///     NPTS= 2000, DT= .02000 SEC        4096    0.0100    NPTS, DT
///
/// in either case, with or without SEC. Refuses it if one is missing.
[[nodiscard]] At2Counts read_at2_counts(const RecordReader& reader);

/// Whether a line says what was measured, e.g. "ACCELERATION TIME HISTORY IN UNITS OF G".
[[nodiscard]] bool names_quantity(std::string_view line);

/// The units that such a line gives, if any. Refuses a velocity, a displacement and units that are
/// not those of an acceleration.
[[nodiscard]] std::optional<RecordUnits> at2_units(const RecordReader& reader);

}  // namespace stillpoint::records
