// SPDX-License-Identifier: MIT
#pragma once

#include "record_lines.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::records {

enum class RecordUnits { g, m_per_s2, cm_per_s2 };

/// As the option --record-units has it: "g", "m/s2", "cm/s2".
[[nodiscard]] std::string_view name(RecordUnits units) noexcept;

/// Throws InputError for any other name.
[[nodiscard]] RecordUnits parse_record_units(const std::string& name);

/// Whether a line of a PEER header says what was measured, e.g. "ACCELERATION TIME HISTORY IN UNITS
/// OF G".
[[nodiscard]] bool names_quantity(std::string_view line);

/// The units that this line of a PEER header gives, none where it gives none. Refuses a velocity, a
/// displacement and units that are none of an acceleration.
[[nodiscard]] std::optional<RecordUnits> header_units(const RecordLines& lines);

}  // namespace stillpoint::records
