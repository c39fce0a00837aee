// SPDX-License-Identifier: MIT
#pragma once

// The reading of a record from a file, and what is read.

#include <stillpoint/core/excitation.hpp>
#include <stillpoint/records/record_options.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace stillpoint::records {

/// An acceleration record as a motion takes it, and what the file says about it.
struct RecordFile {
  Record record;            ///< in g and tau, scaled; at least one value
  std::string description;  ///< what the file says of itself; may be empty
  RecordUnits units{RecordUnits::g};
};

/// Throws InputError, "record-scale", unless 1e-100 <= |scale| <= 1e100.
void require_scale(double scale);

inline constexpr std::size_t largest_record_bytes = std::size_t{64} << 20U;

/// Reads a record in any format of docs/records.md. FILE#2 is channel 2 of FILE, unless there is a
/// file of that name. Throws FileError, with the line, if the file is wrong or contradicts the
/// options, and InputError for a wrong or missing option.
[[nodiscard]] RecordFile read_record(const std::string& path, const RecordOptions& options = {});

/// The same from text that is in memory; `path` stands for it in errors, and its ending may tell
/// the format.
[[nodiscard]] RecordFile parse_record(std::string_view text, const std::string& path,
                                      const RecordOptions& options = {});

/// Whether a text is not a record, not even a wrong one: it matches no format, and neither of its
/// first two lines, comments and blank ones aside, begins with a number. Throws FileError if it is
/// empty or binary.
[[nodiscard]] bool is_plain_text(std::string_view text, const std::string& path);

}  // namespace stillpoint::records
