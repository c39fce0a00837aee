// SPDX-License-Identifier: MIT
#include "value_block.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace stillpoint::records {

namespace {

/// More values than a file within the size limit can contain.
constexpr double largest_count = 1e9;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Where the number that `word` begins with ends: at the sign of the next one. A sign in front of
/// the last three digits may be that of an exponent without its E, and a sign after another sign
/// does not begin a number. Nothing is read twice: a word may be as long as a file.
std::size_t number_end(std::string_view word) {
  constexpr std::size_t exponent = 4;  // a sign and three digits
  for (std::size_t i = 1; i < word.size(); ++i) {
    const bool goes_on = std::string_view("eEdD+-").find(word[i - 1]) != std::string_view::npos;
    if ((word[i] == '+' || word[i] == '-') && !goes_on &&
        !(word.size() - i == exponent && is_number(word))) {
      return i;
    }
  }
  return word.size();
}

std::vector<std::string_view> words_that_touch(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
    while (!word.empty()) {
      fields.push_back(word.substr(0, number_end(word)));
      word.remove_prefix(fields.back().size());
    }
  }
  return fields;
}

[[noreturn]] void refuse_too_many(const RecordReader& reader, const ValueBlock& block) {
  reader.refuse(fmt::format("too many values: more than {} = {} on line {}", block.count_name,
                            block.count, block.count_line));
}

/// A line of numbers right after the last value is too many; text may follow.
void check_end(RecordReader reader, const ValueBlock& block) {
  while (!block.others_follow && reader.next()) {
    const auto fields = fields_of(reader.line(), block.width);
    if (!fields.empty()) {
      if (std::ranges::all_of(fields, is_number)) {
        refuse_too_many(reader, block);
      }
      return;
    }
  }
}

}  // namespace

bool is_number(std::string_view word) {
  return scan_fortran_number(word).fault != NumberFault::no_number;
}

std::size_t whole_count(const RecordReader& reader, std::string_view name, std::string_view text,
                        double value) {
  if (!(value >= 1 && value <= largest_count && value == std::floor(value))) {
    reader.refuse(fmt::format("{} = {}: must be a whole number from 1 to {:.0f}", name,
                              printable(text, longest_word), largest_count));
  }
  return static_cast<std::size_t>(value);
}

std::size_t field_width(std::string_view text) {
  constexpr std::string_view letters = "FEDGIfedgi";
  constexpr std::string_view before = "(0123456789Pp";
  for (std::size_t at = text.find_first_of(letters, 1); at < text.size();
       at = text.find_first_of(letters, at + 1)) {
    std::size_t width = 0;
    const char* const digits = text.data() + at + 1;
    const auto [end, error] = std::from_chars(digits, text.data() + text.size(), width);
    if (error == std::errc() && before.find(text[at - 1]) != std::string_view::npos &&
        is_digit(*digits)) {
      return width;
    }
  }
  return 0;
}

std::vector<std::string_view> fields_of(std::string_view line, std::size_t width) {
  if (width == 0 || line.find('\t') != std::string_view::npos) {
    return words_that_touch(line);
  }
  line = line.substr(0, line.find_last_not_of(' ') + 1);
  std::vector<std::string_view> fields;
  fields.reserve(line.size() / width + 1);
  for (std::size_t at = 0; at < line.size(); at += width) {
    fields.push_back(trimmed(line.substr(at, width)));
  }
  return fields;
}

std::vector<double> read_block(RecordReader& reader, const ValueBlock& block,
                               const ParseField& parse) {
  std::vector<double> values;
  // The header may promise more than the file holds: a value takes a field, or two bytes.
  values.reserve(
      std::min(block.count, reader.bytes_left() / std::max<std::size_t>(block.width, 2) + 1));
  while (values.size() < block.count && reader.next()) {
    const auto fields = fields_of(reader.line(), block.width);
    for (const std::string_view field : fields) {
      if (values.size() == block.count && is_number(field)) {
        refuse_too_many(reader, block);
      }
      if (values.size() == block.count) {
        break;  // text that begins after the last value
      }
      if (!is_number(field)) {
        // The first columns of a line of text carry no information.
        const bool is_cut = block.width > 0 && field.data() == fields.front().data();
        reader.refuse_word(is_cut ? trimmed(reader.line()) : field,
                           fmt::format("is not a number; value {} of {} is expected here{}",
                                       values.size() + 1, block.count, comma_note(field)));
      }
      values.push_back(parse(reader, field));
    }
  }
  if (values.size() < block.count) {
    reader.refuse(fmt::format("too few values: the file ends after {}, but {} = {} on line {}",
                              values.size(), block.count_name, block.count, block.count_line));
  }
  check_end(reader, block);
  return values;
}

}  // namespace stillpoint::records
