// SPDX-License-Identifier: MIT
#pragma once

#include "record_reader.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::records {

/// Whether `word` is a number, also one that is out of range.
[[nodiscard]] bool is_number(std::string_view word);

/// How many values there are, as this line says: `text` is the number `value`.
[[nodiscard]] std::size_t whole_count(const RecordReader& reader, std::string_view name,
                                      std::string_view text, double value);

/// The width of a field in a Fortran format, 10 of (8F10.5) or 8(1PE10.4E1); 0 if `text` has none.
[[nodiscard]] std::size_t field_width(std::string_view text);

/// The fields of a line. With a width each has so many columns and they may touch; without one, or
/// where the line has a tab, they stand between blanks, and a sign inside a word begins a number.
[[nodiscard]] std::vector<std::string_view> fields_of(std::string_view line, std::size_t width);

/// Values in the lines below a header that says how many there are.
struct ValueBlock {
  std::string count_name;  ///< as messages quote it
  std::size_t count{0};
  std::size_t count_line{0};
  std::size_t width{0};       ///< of a field, see `fields_of`
  bool others_follow{false};  ///< other numbers, right after the last value
};

/// What a field of a block stands for; the reader is at its line.
using ParseField = std::function<double(const RecordReader&, std::string_view)>;

/// Reads the block, each field by `parse`. Refuses fewer values, and more of them.
std::vector<double> read_block(RecordReader& reader, const ValueBlock& block,
                               const ParseField& parse);

}  // namespace stillpoint::records
