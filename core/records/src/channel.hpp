// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"

#include <string>
#include <string_view>

namespace stillpoint::records {

/// Leaves `reader` at the line above the values of the channel that the options name, or of the
/// only one. `begins` tells such a line. Refuses a file without one, a file with several if the
/// options name none, and a channel that it does not have.
void go_to_channel(RecordReader& reader, bool (*begins)(std::string_view line));

/// A line with one blank between words.
[[nodiscard]] std::string single_spaced(std::string_view line);

/// The last line up to that of `end` that begins with `key`; "" without one. `start` is at the
/// beginning of the file.
[[nodiscard]] std::string last_line_with(RecordReader start, const RecordReader& end,
                                         std::string_view key);

}  // namespace stillpoint::records
