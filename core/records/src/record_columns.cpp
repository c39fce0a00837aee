// SPDX-License-Identifier: MIT
#include "record_columns.hpp"

#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::records {

namespace {

constexpr std::size_t most_columns = 2;

/// The columns of a line. More than the most there may be are counted, not kept.
struct Row {
  std::array<std::string_view, most_columns> columns;
  std::size_t count{0};
};

/// Between two columns stand blanks, tabs, or one comma with any of these about it.
Row split(std::string_view text, const RecordLines& lines) {
  Row row;
  bool after_comma = true;  // as the beginning of a line: a column must follow
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of(" \t,"), text.size());
    const bool is_comma = length == 0 && text.front() == ',';
    if (is_comma && after_comma) {
      lines.refuse("a column is empty");
    }
    if (length > 0) {
      if (row.count < most_columns) {
        row.columns[row.count] = text.substr(0, length);
      }
      ++row.count;
    }
    after_comma = is_comma || (after_comma && length == 0);
    text.remove_prefix(length > 0 ? length : 1);
  }
  if (after_comma) {
    lines.refuse("a column is empty");
  }
  return row;
}

/// Takes the comment off the line and notes the first one.
std::string_view without_comment(std::string_view line, std::string& description) {
  const std::size_t at = line.find('#');
  if (at != std::string_view::npos && description.empty()) {
    constexpr std::size_t longest_description = 200;
    const std::size_t begin = std::min(line.find_first_not_of("# \t", at), line.size());
    description = printable(trimmed(line.substr(begin)), longest_description);
  }
  return trimmed(line.substr(0, at));
}

/// A heading is the likeliest text in front of the values.
void check_heading(const Row& row, const RecordLines& lines) {
  if (scan_fortran_number(row.columns[0]).fault == NumberFault::no_number) {
    lines.refuse(fmt::format("{} {}; a heading above columns begins with #, a PEER record has NPTS",
                             quoted(row.columns[0]), explanation(NumberFault::no_number)));
  }
}

void check_count(const Row& row, std::size_t wanted, const RecordColumns& record,
                 const RecordLines& lines) {
  if (row.count > most_columns) {
    lines.refuse(fmt::format("{} columns: must be time and value, or value alone", row.count));
  }
  if (row.count != wanted) {
    lines.refuse(fmt::format("{} column{}, but {} in line {}", row.count, row.count == 1 ? "" : "s",
                             wanted, record.first_line));
  }
}

void add_time(std::string_view text, RecordColumns& record, const RecordLines& lines,
              const RecordClock& clock) {
  const double time = lines.parse_number(text);
  if (!(time >= 0)) {
    lines.refuse(fmt::format("time {} {}: must be at least 0", time, clock.unit));
  }
  if (!clock.reaches(time)) {
    lines.refuse(
        fmt::format("time {} {}: must be at most {:.3g}", time, clock.unit, clock.latest()));
  }
  if (!record.times.empty()) {
    const double before = record.times.back();
    if (!(time > before)) {
      lines.refuse(fmt::format("time {}: must be more than {}, the time before it", time, before));
    }
    if (!clock.tells_apart(before, time)) {
      lines.refuse(fmt::format("time {} {}: is too near to {}, the time before it", time,
                               clock.unit, before));
    }
  }
  record.times.push_back(time);
}

}  // namespace

RecordColumns read_columns(RecordLines& lines, const RecordScale& scale, const RecordClock& clock) {
  RecordColumns record;
  std::size_t count = 0;
  while (lines.next()) {
    const std::string_view line = without_comment(lines.line(), record.description);
    if (line.empty()) {
      continue;
    }
    const Row row = split(line, lines);
    if (record.first_line == 0) {
      check_heading(row, lines);
      record.first_line = lines.number();
      count = row.count;
    }
    check_count(row, count, record, lines);
    if (count == most_columns) {
      add_time(row.columns[0], record, lines, clock);
    }
    record.values.push_back(scale.read(row.columns[count - 1], lines));
  }
  if (record.values.empty()) {
    lines.refuse("the file ends without a value");
  }
  return record;
}

double uniform_step(const std::vector<double>& times) {
  constexpr double tolerance = 0x1p-51;
  if (times.size() < 2 || times[0] != 0) {
    return 0;
  }
  const double step = times[1];
  for (std::size_t i = 2; i < times.size(); ++i) {
    if (!(std::abs(times[i] - static_cast<double>(i) * step) <= tolerance * times[i])) {
      return 0;
    }
  }
  return step;
}

}  // namespace stillpoint::records
