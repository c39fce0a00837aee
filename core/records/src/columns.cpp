// SPDX-License-Identifier: MIT

// One or two columns between blanks, tabs or commas: time and value, or value alone. What follows a
// # is a comment; blank lines are skipped.

#include "record_reader.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace stillpoint::records {

namespace {

constexpr std::size_t most_columns = 2;

using Columns = std::vector<std::string_view>;

/// Between two columns there are blanks, tabs, or one comma with any of these around it.
Columns columns_of(std::string_view text, const RecordReader& reader) {
  Columns columns;
  for (const std::string_view part : split(text, ',')) {
    const Columns words = words_of(part, " \t");
    if (words.empty()) {
      reader.refuse("a column is empty");
    }
    columns.insert(columns.end(), words.begin(), words.end());
  }
  return columns;
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

/// Text before the values is most likely a heading.
void check_heading(std::string_view first, const RecordReader& reader) {
  if (first.find(';') != std::string_view::npos) {
    reader.refuse_word(first, fmt::format("is not a number; between columns there must be "
                                          "blanks, tabs or a comma, no semicolon{}",
                                          comma_note(reader.line())));
  }
  if (scan_fortran_number(first).fault == NumberFault::no_number) {
    reader.refuse_word(first,
                       fmt::format("{}; a heading above columns must begin with #, and a PEER "
                                   "record has the word NPTS",
                                   explanation(NumberFault::no_number)));
  }
}

void check_count(std::size_t count, std::size_t expected, std::size_t first_line,
                 const RecordReader& reader) {
  if (count > most_columns) {
    const std::string_view comma = comma_note(reader.line());
    reader.refuse(fmt::format(
        "{} columns: must be time and value, or value alone{}", count,
        comma.empty() ? "; a file with many values per line needs a header with NPTS and DT"
                      : comma));
  }
  if (count != expected) {
    reader.refuse(fmt::format("{} column{}, but {} on line {}", count, count == 1 ? "" : "s",
                              expected, first_line));
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
                                comma_note(reader.line())));
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
    const Columns columns = columns_of(line, reader);
    if (first_line == 0) {
      check_heading(columns[0], reader);
      first_line = reader.number();
      count = columns.size();
    }
    check_count(columns.size(), count, first_line, reader);
    if (count == most_columns) {
      times.add(columns[0], reader);
    }
    file.record.values.push_back(reader.parse_acceleration(columns.back()));
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
        "record-step",
        fmt::format("record {}, line {}: the file has no times, so it needs a step in {}",
                    reader.path(), first_line, options.clock.unit));
  }
  return file;
}

}  // namespace

constinit const RecordFormat columns_format{"columns", ".TXT .CSV .DAT", is_columns, read_columns};

}  // namespace stillpoint::records
