// SPDX-License-Identifier: MIT

// One or two columns between blanks, tabs or commas: time and value, or value alone. What follows a
// # is a comment; blank lines are skipped.

#include "record_reader.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stillpoint::records {

namespace {

constexpr std::size_t most_columns = 2;

/// The columns of a line. Those beyond the allowed number are counted, not kept.
struct Row {
  std::array<std::string_view, most_columns> columns;
  std::size_t count{0};
};

/// Between two columns there are blanks, tabs, or one comma with any of these around it.
Row split(std::string_view text, const RecordReader& reader) {
  Row row;
  bool after_comma = true;  // like the beginning of a line: a column must follow
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of(" \t,"), text.size());
    const bool is_comma = length == 0 && text.front() == ',';
    if (is_comma && after_comma) {
      reader.refuse("a column is empty");
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
    reader.refuse("a column is empty");
  }
  return row;
}

/// Takes the comment off the line. The first one is the description.
std::string_view without_comment(std::string_view line, std::string& description) {
  const std::size_t at = line.find('#');
  if (at != std::string_view::npos && description.empty()) {
    const std::size_t begin = std::min(line.find_first_not_of("# \t", at), line.size());
    description = printable(trimmed(line.substr(begin)), longest_description);
  }
  return trimmed(line.substr(0, at));
}

/// What a spreadsheet may have written: "0,01" for 0.01 makes two columns of one.
std::string_view decimal_comma(const RecordReader& reader) {
  const std::string_view line = reader.line();
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (line[i] == ',' && is_digit(line[i - 1]) && is_digit(line[i + 1])) {
      return "; a decimal comma must be a point";
    }
  }
  return "";
}

/// Text before the values is most likely a heading.
void check_heading(const Row& row, const RecordReader& reader) {
  if (row.columns[0].find(';') != std::string_view::npos) {
    reader.refuse_word(row.columns[0], fmt::format("is not a number; between columns there must be "
                                                   "blanks, tabs or a comma, no semicolon{}",
                                                   decimal_comma(reader)));
  }
  if (scan_fortran_number(row.columns[0]).fault == NumberFault::no_number) {
    reader.refuse_word(row.columns[0],
                       fmt::format("{}; a heading above columns must begin with #, and a PEER "
                                   "record has the word NPTS",
                                   explanation(NumberFault::no_number)));
  }
}

void check_count(const Row& row, std::size_t expected, std::size_t first_line,
                 const RecordReader& reader) {
  if (row.count > most_columns) {
    reader.refuse(fmt::format("{} columns: must be time and value, or value alone{}", row.count,
                              decimal_comma(reader)));
  }
  if (row.count != expected) {
    reader.refuse(fmt::format("{} column{}, but {} on line {}", row.count,
                              row.count == 1 ? "" : "s", expected, first_line));
  }
}

/// The times of a file. They become the step h = t_1 if they are 0, h, 2 h, ... except for the
/// rounding of doubles:
///
///     t_0 = 0  and  |t_i - i h| <= 2^-51 t_i  for every i.
///
/// A decimal time is off its double by 2^-53, relative; so is h, and so is the product. The bound
/// leaves room for these three and no more: the step moves no time further than two units in its
/// last place. Times that were rounded to fewer digits (0, 0.0333, 0.0667) stay as they are.
class TimeColumn {
 public:
  void add(std::string_view word, const RecordReader& reader) {
    const RecordClock& clock = reader.options().clock;
    const double time = reader.parse_number(word);
    check(time, clock, reader);
    note_step(time);
    before_ = time;
    taus_.push_back(time / clock.per_tau);
  }

  /// The step or the times, in tau.
  void move_to(Record& record) {
    if (taus_.size() > 1 && is_uniform_) {
      record.step = taus_[1];
    } else {
      record.times = std::move(taus_);
    }
  }

 private:
  void check(double time, const RecordClock& clock, const RecordReader& reader) const {
    if (!(time >= 0)) {
      reader.refuse(fmt::format("time {} {}: must be at least 0", time, clock.unit));
    }
    if (!clock.reaches(time)) {
      reader.refuse(
          fmt::format("time {} {}: must be at most {:.3g}", time, clock.unit, clock.latest()));
    }
    if (taus_.empty()) {
      return;
    }
    if (!(time > before_)) {
      reader.refuse(fmt::format("time {}: must be more than the previous time, {}{}", time, before_,
                                decimal_comma(reader)));
    }
    if (!clock.tells_apart(before_, time)) {
      reader.refuse(fmt::format("time {} {}: is too close to the previous time, {}", time,
                                clock.unit, before_));
    }
  }

  void note_step(double time) {
    constexpr double tolerance = 0x1p-51;  // the step and its multiple are rounded
    const std::size_t i = taus_.size();
    if (i == 1) {
      step_ = time;
    }
    is_uniform_ =
        is_uniform_ && std::abs(time - static_cast<double>(i) * step_) <= tolerance * time;
  }

  std::vector<double> taus_;
  double before_{0};  ///< as this and the step are in the file
  double step_{0};
  bool is_uniform_{true};
};

bool is_columns(RecordReader /*reader*/) {
  return true;
}

RecordFile read_columns(RecordReader& reader) {
  const RecordOptions& options = reader.options();
  RecordFile file{{}, {}, options.units.value_or(RecordUnits::g), !options.units};
  reader.set_units(file.units);
  TimeColumn times;
  std::size_t first_line = 0;
  std::size_t count = 0;
  while (reader.next()) {
    const std::string_view line = without_comment(reader.line(), file.description);
    if (line.empty()) {
      continue;
    }
    const Row row = split(line, reader);
    if (first_line == 0) {
      check_heading(row, reader);
      first_line = reader.number();
      count = row.count;
    }
    check_count(row, count, first_line, reader);
    if (count == most_columns) {
      times.add(row.columns[0], reader);
    }
    file.record.values.push_back(reader.parse_acceleration(row.columns[count - 1]));
  }
  if (file.record.values.empty()) {
    reader.refuse("the file has no values");
  }
  if (count == most_columns) {
    reader.refuse_step(first_line, "the file gives a time with each value");
    times.move_to(file.record);
  } else if (options.step) {
    file.record.step = *options.step / options.clock.per_tau;
    file.takes_step = true;
  } else {
    throw InputError::missing(
        "record-step", fmt::format("record {}, line {}: values without times need their step in {}",
                                   reader.path(), first_line, options.clock.unit));
  }
  return file;
}

}  // namespace

constinit const RecordFormat columns_format{is_columns, read_columns};

}  // namespace stillpoint::records
