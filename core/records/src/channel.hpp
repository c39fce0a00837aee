// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"
#include "value_block.hpp"

#include <string>
#include <string_view>

namespace stillpoint::records {

/// Leaves `reader` at the line above the values of the channel that the options name, or of the
/// only one. `begins` tells such a line. Refuses a file without one, a file with several if the
/// options name none, and a channel that it does not have.
void go_to_channel(RecordReader& reader, bool (*begins)(std::string_view line));

/// A line with one blank between words.
[[nodiscard]] std::string single_spaced(std::string_view line);

/// The block below a line that gives the count of points, `count`, and a Fortran format.
[[nodiscard]] ValueBlock points_below(const RecordReader& reader, std::string_view count);

/// What the line above the values of a channel gives.
struct Channel {
  ValueBlock block;
  double step{0};  ///< in tau
  RecordUnits units{RecordUnits::g};
};

/// Reads the values of the channel from the lines below `reader`. Its description is the last line
/// above them that begins with each of the two keys; `start` is at the beginning of the file.
[[nodiscard]] RecordFile read_channel(const RecordReader& start, RecordReader& reader,
                                      const Channel& channel, std::string_view station_key,
                                      std::string_view channel_key);

}  // namespace stillpoint::records
