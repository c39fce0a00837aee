// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"
#include "value_block.hpp"

#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::records {

/// Leaves `reader` at the line above the values of the channel that the options name, or of the
/// only one. `begins` tells such a line. Refuses a file without one, a file with several if the
/// options name none, and a channel that it does not have.
void go_to_channel(RecordReader& reader, bool (*begins)(std::string_view line));

/// A line with one blank between words.
[[nodiscard]] std::string single_spaced(std::string_view line);

/// Text of a header, and the line in which it stands.
struct HeaderText {
  std::string_view text;
  RecordReader reader;
};

/// The fields of the lines below `reader`, down to line `last` or the hundredth field.
[[nodiscard]] std::vector<HeaderText> fields_below(RecordReader reader, std::size_t last,
                                                   std::size_t width);

/// What follows `key`, without blanks, in the first line of a header that begins with it; empty
/// without such a line, or with nothing behind the key.
[[nodiscard]] std::optional<HeaderText> find_key(const std::vector<RecordReader>& header,
                                                 std::string_view key);
/// The same; refuses a header without it, at its last line.
[[nodiscard]] HeaderText text_of(const std::vector<RecordReader>& header, std::string_view key);
/// The texts of these keys, in a line.
[[nodiscard]] std::string described(const std::vector<RecordReader>& header,
                                    std::initializer_list<std::string_view> keys);

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
