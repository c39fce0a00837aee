// SPDX-License-Identifier: MIT
#include "at2_values.hpp"

#include "at2_count_line.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace stillpoint::records {

namespace {

bool is_number(std::string_view word) {
  return scan_fortran_number(word).fault != NumberFault::no_number;
}

bool is_values(std::string_view line) {
  std::string_view word = take_word(line);
  if (word.empty()) {
    return false;
  }
  while (!word.empty() && is_number(word)) {
    word = take_word(line);
  }
  return word.empty();
}

std::size_t count_words(std::string_view line) {
  std::size_t count = 0;
  while (!take_word(line).empty()) {
    ++count;
  }
  return count;
}

/// Refuses more values than the header says; where they stand and how many there are.
void refuse_surplus(RecordLines lines, const At2Header& header, std::size_t surplus) {
  const std::size_t first = lines.number();
  while (lines.next() && (is_values(lines.line()) || trimmed(lines.line()).empty())) {
    surplus += count_words(lines.line());
  }
  lines.refuse(first, fmt::format("too many values: {}, but NPTS = {} in line {}",
                                  header.count + surplus, header.count, header.line));
}

/// What follows the last value: nothing but blank lines and text, and no second record.
void check_trailer(RecordLines& lines, const At2Header& header) {
  bool is_text = false;
  while (lines.next()) {
    if (has_npts(lines.line())) {
      lines.refuse("a second record begins here: a file must hold one");
    }
    if (!is_text && is_values(lines.line())) {
      refuse_surplus(lines, header, count_words(lines.line()));
    }
    is_text = is_text || !trimmed(lines.line()).empty();
  }
}

}  // namespace

std::vector<double> read_at2_values(RecordLines& lines, const At2Header& header,
                                    const RecordScale& scale) {
  std::vector<double> values;
  // The header may promise more than the file holds: a value takes two bytes.
  values.reserve(std::min(header.count, lines.bytes_left() / 2 + 1));
  while (values.size() < header.count && lines.next()) {
    std::string_view rest = lines.line();
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (values.size() == header.count) {
        if (is_number(word)) {
          refuse_surplus(lines, header, 1 + count_words(rest));
        }
        break;  // a trailer that begins behind the last value
      }
      if (!is_number(word)) {
        lines.refuse(fmt::format("{} is not a number; value {} of {} should stand here",
                                 quoted(word), values.size() + 1, header.count));
      }
      values.push_back(scale.read(word, lines));
    }
  }
  if (values.size() < header.count) {
    lines.refuse(fmt::format("too few values: the file ends after {}, but NPTS = {} in line {}",
                             values.size(), header.count, header.line));
  }
  check_trailer(lines, header);
  return values;
}

}  // namespace stillpoint::records
