// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace stillpoint::records {

/// A line in upper case without blanks around a '/'; CM/SEC/SEC as CM/S/S, CM/S**2 and CM/S^2 as
/// CM/S2.
[[nodiscard]] std::string normal_units(std::string_view line);

/// The units of acceleration that a word, as `normal_units` leaves it, is, without the full stop of
/// its sentence; if any.
[[nodiscard]] std::optional<RecordUnits> acceleration_units(std::string_view word);

/// Whether a word, as `normal_units` leaves it, can only mean units: of an acceleration or
/// of a velocity.
[[nodiscard]] bool must_be_units(std::string_view word);

/// The units of acceleration that `word`, in the line where `reader` is, stands for. Refuses any
/// others.
[[nodiscard]] RecordUnits read_units(const RecordReader& reader, std::string_view word);

inline constexpr std::string_view wanted_units = "an acceleration is needed, in G, CM/S2 or M/S2";

}  // namespace stillpoint::records
