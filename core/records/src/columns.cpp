// SPDX-License-Identifier: MIT

// Columns between blanks, tabs or commas: times and the values of one or several components, or
// values alone, any number of them in a line. What follows a # is a comment; blank lines are
// skipped; the first line may be a heading, or the count of values and their step.

#include "acceleration_units.hpp"
#include "channel.hpp"
#include "record_reader.hpp"
#include "time_column.hpp"
#include "value_block.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillpoint::records {

namespace {

/// The rows of a file, one after the other.
class Rows {
 public:
  explicit Rows(const RecordReader& reader) : reader_(reader) {}

  /// Goes to the next row; false behind the last one. A heading is passed over.
  bool next() {
    while (reader_.next()) {
      const std::string_view line = without_comment(reader_.line());
      if (line.empty()) {
        continue;
      }
      split_columns(line);
      if (first_line_ > 0 || is_number(columns_.front()) || has_heading_) {
        first_line_ = first_line_ == 0 ? reader_.number() : first_line_;
        return true;
      }
      refuse_semicolons(line);
      has_heading_ = true;
      note(line);
    }
    at_end_ = true;
    return false;
  }

  [[nodiscard]] bool at_end() const { return at_end_; }
  [[nodiscard]] const RecordReader& reader() const { return reader_; }
  [[nodiscard]] const std::vector<std::string_view>& columns() const { return columns_; }
  [[nodiscard]] std::size_t first_line() const { return first_line_; }
  /// The first comment, or else the heading.
  [[nodiscard]] const std::string& description() const { return description_; }
  /// The units that comments and the heading name, if they name one kind only.
  [[nodiscard]] std::optional<RecordUnits> named_units() const { return units_; }

 private:
  void note(std::string_view text) {
    if (description_.empty()) {
      description_ = printable(trimmed(text), longest_description);
    }
    const std::string normal = normal_units(text);
    for (const std::string_view word : words_of(normal, " \t,;:=()[]\"")) {
      if (const auto units = acceleration_units(word)) {
        is_ambiguous_ = is_ambiguous_ || (units_ && *units_ != *units);
        units_ = is_ambiguous_ ? std::nullopt : units;
      }
    }
  }

  std::string_view without_comment(std::string_view line) {
    const std::size_t at = line.find('#');
    if (at != std::string_view::npos) {
      note(line.substr(std::min(line.find_first_not_of("# \t", at), line.size())));
    }
    return trimmed(line.substr(0, at));
  }

  /// Between two columns there are blanks, tabs, or one comma with any of these around it. Quotes
  /// around a number mean nothing.
  void split_columns(std::string_view line) {
    columns_.clear();
    for (const std::string_view part : split(line, ',')) {
      const auto words = words_of(part, " \t\"");
      if (words.empty()) {
        reader_.refuse("a column is empty");
      }
      columns_.insert(columns_.end(), words.begin(), words.end());
    }
  }

  void refuse_semicolons(std::string_view line) const {
    if (line.find(';') != std::string_view::npos) {
      reader_.refuse_word(line, fmt::format("is not a number; between columns there must be "
                                            "blanks, tabs or a comma, no semicolon{}",
                                            comma_note(line)));
    }
  }

  RecordReader reader_;
  std::vector<std::string_view> columns_;
  std::size_t first_line_{0};
  bool has_heading_{false};
  bool at_end_{false};
  std::string description_;
  std::optional<RecordUnits> units_;
  bool is_ambiguous_{false};
};

double number_of(std::string_view word) {
  const ScannedNumber scanned = scan_fortran_number(word);
  return scanned.fault == NumberFault::none ? scanned.value : std::nan("");
}

/// How the rows are read.
struct Plan {
  bool is_counted{false};  ///< the first row is the count of the values below it, and their step
  bool has_times{false};   ///< in the first column
  bool by_line{false};     ///< all values of a row are read, not one column
  std::size_t columns{0};  ///< of the first row; 0: there is none
};

/// Two numbers, a count and a step, are no time and value unless the second row goes on so. Where
/// it matters, times are what increases.
Plan plan_of(const RecordReader& reader) {
  const RecordOptions& options = reader.options();
  Rows rows(reader);
  Plan plan;
  plan.columns = rows.next() ? rows.columns().size() : 0;
  double before = plan.columns == 0 ? 0 : number_of(rows.columns()[0]);
  const bool may_be_count = plan.columns == 2 && !options.channel && before >= 2 &&
                            before == std::floor(before) && number_of(rows.columns()[1]) > 0;
  bool increases = rows.next() && number_of(rows.columns()[0]) > before;
  plan.is_counted = may_be_count && !rows.at_end() && !(increases && rows.columns().size() == 2);
  while (increases && (plan.columns > 2 || options.step)) {
    before = number_of(rows.columns()[0]);
    if (!rows.next()) {
      break;
    }
    increases = number_of(rows.columns()[0]) > before;
  }
  plan.has_times = plan.columns > 1 && !plan.is_counted && (increases || !options.step);
  plan.by_line = plan.is_counted || plan.columns == 1 || !(plan.has_times || options.channel);
  return plan;
}

/// Of the values, from 0. Refuses columns that are no components, at the first row.
std::size_t value_column(const RecordReader& reader, const Plan& plan) {
  if (plan.by_line) {
    return chosen_channel(reader, 1, "");
  }
  if (plan.has_times) {
    reader.refuse_step(reader.number(), "the file gives a time with each value");
  }
  const std::size_t times = plan.has_times ? 1 : 0;
  return times + chosen_channel(reader, plan.columns - times,
                                fmt::format("{} columns{}", plan.columns,
                                            plan.has_times ? ", the first of times (values "
                                                             "without times need record-step)"
                                                           : ""));
}

/// A line of decimal commas would be read as twice as many numbers.
void refuse_decimal_commas(const RecordReader& reader, std::size_t count) {
  const std::string_view comma = comma_note(reader.line());
  if (!comma.empty() && reader.line().find('.') == std::string_view::npos) {
    reader.refuse(fmt::format("{} columns{}", count, comma));
  }
}

/// Of each row that is left.
std::vector<double> read_rows(Rows& rows, const Plan& plan, TimeColumn& times) {
  std::vector<double> values;
  std::size_t columns = 0;
  std::size_t column = 0;
  bool is_short = false;
  while (rows.next()) {
    const RecordReader& reader = rows.reader();
    const std::size_t count = rows.columns().size();
    if (count > 2 || (count > 1 && plan.by_line)) {
      refuse_decimal_commas(reader, count);
    }
    if (values.empty()) {
      columns = count;
      column = value_column(reader, plan);
    }
    if (count > columns || is_short || (count < columns && !plan.by_line)) {
      reader.refuse(fmt::format("{} column{}, but {} on line {}", count, count == 1 ? "" : "s",
                                columns, rows.first_line()));
    }
    is_short = count < columns;  // the last line of values may be
    if (plan.has_times) {
      times.add(reader.parse_number(rows.columns()[0]), reader);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (plan.by_line || i == column) {
        values.push_back(reader.parse_acceleration(rows.columns()[i]));
      }
    }
  }
  return values;
}

/// Reads the first row, which has the step. The count.
std::size_t read_count(Rows& rows, double& step) {
  rows.next();
  const RecordReader& reader = rows.reader();
  const std::string_view count = rows.columns()[0];
  step = reader.file_step(reader.number(), "the step", reader.parse_number(rows.columns()[1]));
  return whole_count(reader, "the count", count, reader.parse_number(count));
}

/// That of the options.
double given_step(const Rows& rows) {
  const RecordOptions& options = rows.reader().options();
  if (!options.step) {
    throw InputError::missing(
        "record-step",
        fmt::format("record {}, line {}: the file has no times, so it needs a step in {}",
                    rows.reader().path(), rows.first_line(), options.clock.unit));
  }
  return *options.step / options.clock.per_tau;
}

/// Values that follow each other differ less than those that are a line apart, unless the columns
/// of a line are components.
bool looks_like_components(const std::vector<double>& values, std::size_t columns) {
  constexpr double clearly = 0.7;
  double next = 0;
  double below = 0;
  for (std::size_t i = columns; i < values.size(); ++i) {
    next += std::abs(values[i] - values[i - 1]);
    below += std::abs(values[i] - values[i - columns]);
  }
  return columns > 1 && below < clearly * next;
}

std::string doubt_of(const RecordFile& file, const Plan& plan, const Rows& rows) {
  if (const auto named = rows.named_units(); file.assumed_g && named && named != RecordUnits::g) {
    return fmt::format(
        "it names the units {0}, but its values are read in g; did you mean --record-units {0}?",
        name(*named));
  }
  return plan.by_line && looks_like_components(file.record.values, plan.columns)
             ? fmt::format(
                   "its {0} values a line are read one after the other; if the columns are "
                   "components, choose one, #1 to #{0} behind the name",
                   plan.columns)
             : "";
}

bool is_columns(RecordReader /*reader*/) {
  return true;
}

RecordFile read_columns(RecordReader& reader) {
  const RecordOptions& options = reader.options();
  RecordFile file{{}, {}, options.units.value_or(RecordUnits::g), !options.units};
  reader.set_units(file.units);
  const Plan plan = plan_of(reader);
  Rows rows(reader);
  const std::size_t count = plan.is_counted ? read_count(rows, file.record.step) : 0;
  TimeColumn times;
  file.record.values = read_rows(rows, plan, times);
  const std::size_t found = file.record.values.size();
  if (found == 0 || (plan.is_counted && found != count)) {
    rows.reader().refuse(plan.is_counted ? fmt::format("{} values follow, but {} on line {}", found,
                                                       count, rows.first_line())
                                         : "the file has no values");
  }
  if (plan.has_times) {
    times.move_to(file.record);
  } else if (!plan.is_counted) {
    file.record.step = given_step(rows);
    file.takes_step = true;
  }
  file.description = rows.description() + times.note();
  file.doubt = doubt_of(file, plan, rows);
  return file;
}

}  // namespace

constinit const RecordFormat columns_format{"columns", ".TXT .CSV .DAT", is_columns, read_columns,
                                            true};

}  // namespace stillpoint::records
