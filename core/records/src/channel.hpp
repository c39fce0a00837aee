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

/// The channel that the options name, of `count`, from 0; the only one if they name none. Refuses
/// others at the line of `reader`; `several` says that there are several.
[[nodiscard]] std::size_t chosen_channel(const RecordReader& reader, std::size_t count,
                                         std::string_view several);

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

/// Number `wanted`, counted from 1, of the header that takes the next `lines` lines in fields of
/// `width` columns.
[[nodiscard]] HeaderText header_number(const RecordReader& reader, std::size_t lines,
                                       std::size_t width, std::size_t wanted);
[[nodiscard]] double value_of(const HeaderText& number);

/// Goes on by `lines` lines, which must be there.
void skip(RecordReader& reader, std::size_t lines);

/// What follows `key`, without blanks, in the first line of a header that begins with it; empty
/// without such a line, or with nothing behind the key.
[[nodiscard]] std::optional<HeaderText> find_key(const std::vector<RecordReader>& header,
                                                 std::string_view key);
/// The same; refuses a header without it, at its last line.
[[nodiscard]] HeaderText text_of(const std::vector<RecordReader>& header, std::string_view key);
/// What follows the first colon, without blanks; the whole text without a colon.
[[nodiscard]] std::string_view after_colon(std::string_view text);
/// The texts of these keys, in a line.
[[nodiscard]] std::string described(const std::vector<RecordReader>& header,
                                    std::initializer_list<std::string_view> keys);

/// A number that a header gives, by its name in messages. If it is not the text itself, `value` is
/// what follows from it.
struct HeaderNumber {
  std::string_view name;
  HeaderText given;
  std::optional<double> value{};
};

/// A table of columns, of which one is read; see ValueBlock for its width and what follows.
struct Table {
  std::size_t width{0};
  std::size_t columns{1};
  std::size_t column{0};  ///< from 0
  bool others_follow{false};
};

/// Reads the values from the lines below `reader`: so many rows, with this step in s. Line
/// `units_line` gives their units.
[[nodiscard]] RecordFile read_described(RecordReader& reader, const HeaderNumber& count,
                                        const HeaderNumber& step, RecordUnits units,
                                        std::size_t units_line, const Table& table,
                                        std::string_view description);

/// The last line of `start` up to the line of `end` that begins with the first key, and that with
/// the second.
[[nodiscard]] std::string described(const RecordReader& start, const RecordReader& end,
                                    std::string_view station_key, std::string_view channel_key);

}  // namespace stillpoint::records
