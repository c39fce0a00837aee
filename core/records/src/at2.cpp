// SPDX-License-Identifier: MIT

// PEER's .AT2: titles, a line that names the quantity and its units, and the line with NPTS and DT,
// which is the fourth or the seventh of most files. Then the values, any number of them in a line,
// NPTS in all; blank lines and text may follow.

#include "at2_parts.hpp"
#include "record_reader.hpp"
#include "value_block.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace stillpoint::records {

namespace {

/// NPTS must be in one of these lines, not in a comment (#).
constexpr std::size_t longest_header = 32;

struct Header {
  At2Counts counts;
  std::size_t line{0};  ///< of the counts
  std::optional<RecordUnits> units;
  std::size_t units_line{0};
  std::string titles;
};

bool has_counts(std::string_view line) {
  return has_npts(line) && !trimmed(line).starts_with('#');
}

bool is_at2(RecordReader reader) {
  if (upper_case(reader.path()).ends_with(".AT2")) {
    return true;
  }
  while (reader.number() < longest_header && reader.next()) {
    if (has_counts(reader.line())) {
      return true;
    }
  }
  return false;
}

void note_units(const RecordReader& reader, Header& header) {
  const auto units = at2_units(reader);
  if (!units) {
    return;
  }
  if (header.units && *header.units != *units) {
    reader.refuse(fmt::format("units of {} contradict those of line {}, {}", name(*units),
                              header.units_line, name(*header.units)));
  }
  header.units = units;
  header.units_line = reader.number();
}

/// Leaves `reader` at the last line of the header.
Header read_header(RecordReader& reader) {
  Header header;
  while (reader.number() < longest_header && reader.next()) {
    const std::string_view line = reader.line();
    const bool is_quantity = names_quantity(line);
    if (is_quantity) {
      note_units(reader, header);
    }
    if (has_counts(line)) {
      header.counts = read_at2_counts(reader);
      header.line = reader.number();
      return header;
    }
    const std::string_view title = trimmed(line);
    if (!is_quantity && !title.empty()) {
      header.titles += (header.titles.empty() ? "" : "; ") + std::string(title);
    }
  }
  reader.refuse(
      "NPTS and DT are missing: a PEER record has a line such as NPTS= 2000, DT= .02 SEC");
}

/// The words of a line; numbers may touch.
std::vector<std::string_view> words_in(const RecordReader& reader) {
  return fields_of(reader.line(), 0);
}

/// How many values a line holds; 0 if it is blank or has a word that is not a number.
std::size_t count_values(const RecordReader& reader) {
  const auto words = words_in(reader);
  return std::ranges::all_of(words, is_number) ? words.size() : 0;
}

/// Refuses more values than the header says: `surplus` in this line and those of the next lines.
[[noreturn]] void refuse_surplus(RecordReader reader, const Header& header, std::size_t surplus) {
  const std::size_t first = reader.number();
  while (reader.next() && (count_values(reader) > 0 || trimmed(reader.line()).empty())) {
    surplus += count_values(reader);
  }
  const std::size_t count = header.counts.count;
  reader.refuse(first, fmt::format("too many values: {}, but NPTS = {} on line {}", count + surplus,
                                   count, header.line));
}

/// After the last value there may be blank lines and text, but no second record.
void check_trailer(RecordReader& reader, const Header& header) {
  bool is_text = false;
  while (reader.next()) {
    if (has_npts(reader.line())) {
      reader.refuse("a second record begins here: a file must hold only one");
    }
    const std::size_t surplus = count_values(reader);
    if (!is_text && surplus > 0) {
      refuse_surplus(reader, header, surplus);
    }
    is_text = is_text || !trimmed(reader.line()).empty();
  }
}

std::vector<double> read_values(RecordReader& reader, const Header& header) {
  const std::size_t count = header.counts.count;
  std::vector<double> values;
  // The header may promise more than the file contains: a value takes two bytes.
  values.reserve(std::min(count, reader.bytes_left() / 2 + 1));
  while (values.size() < count && reader.next()) {
    const auto words = words_in(reader);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string_view word = words[i];
      if (values.size() == count) {
        if (is_number(word)) {
          refuse_surplus(reader, header, words.size() - i);
        }
        break;  // a trailer that begins after the last value
      }
      if (!is_number(word)) {
        reader.refuse_word(word, fmt::format("is not a number; value {} of {} is expected here",
                                             values.size() + 1, count));
      }
      values.push_back(reader.parse_acceleration(word));
    }
  }
  if (values.size() < count) {
    reader.refuse(fmt::format("too few values: the file ends after {}, but NPTS = {} on line {}",
                              values.size(), count, header.line));
  }
  check_trailer(reader, header);
  return values;
}

RecordFile read_at2(RecordReader& reader) {
  const Header header = read_header(reader);
  const double step = reader.file_step(header.line, "DT", header.counts.step);
  const RecordUnits units = header.units.value_or(reader.options().units.value_or(RecordUnits::g));
  reader.set_units(units, header.units_line);
  return {{read_values(reader, header), step, {}},
          printable(header.titles, longest_description),
          units};
}

}  // namespace

constinit const RecordFormat at2_format{is_at2, read_at2};

}  // namespace stillpoint::records
