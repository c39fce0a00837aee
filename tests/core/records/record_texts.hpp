// SPDX-License-Identifier: MIT
#pragma once

// Records as text, right and wrong, for the tests of each form.

#include "testing/test.hpp"
#include "testing/unescaped.hpp"

#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/record_file.hpp>

namespace stillpoint::test {

using namespace stillpoint;
using records::FileError;
using records::RecordFile;
using records::RecordOptions;
using records::RecordUnits;

using Samples = std::vector<double>;

inline const std::string titles =
    "PEER NGA STRONG MOTION DATABASE RECORD\n"
    "NOWHERE 01/02/03, SOME STATION, 090\n";
inline const std::string quantity = "ACCELERATION TIME HISTORY IN UNITS OF G\n";
inline const std::string header = titles + quantity + "NPTS= 3, DT= .02000 SEC\n";
inline const std::string three = "0.5 -1 0.25\n";
inline const Samples plain{0.5, -1, 0.25};
inline const std::string uneven = "0 0.5\n0.1 -1\n0.25 0.25\n";

/// A double as it is read back to the last bit.
inline std::string in_full(double value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

/// A row of a table in files: a text, or a sample with a fault, and what is read of it or why not.
struct Row {
  std::string name;
  RecordOptions options{};
  std::string text{};
  std::string old{};
  std::string now{};
  std::string says{};  ///< "..." stands for anything; empty: it is right
  Samples values{plain};
  Samples times{};
  double step{0};
};

/// "step=0.02" and the like.
inline void set_option(RecordOptions& options, const std::string& word) {
  const std::string name = word.substr(0, word.find('='));
  const std::string text = word.substr(name.size() + 1);
  if (name == "units") {
    options.units = text == "g"      ? RecordUnits::g
                    : text == "m/s2" ? RecordUnits::m_per_s2
                                     : RecordUnits::cm_per_s2;
  } else if (name == "channel") {
    options.channel = std::stoul(text);
  } else {
    double& number = name == "step"    ? options.step.emplace()
                     : name == "scale" ? options.scale
                     : name == "p"     ? options.clock.p
                                       : options.gravity_m_per_s2;
    number = std::stod(text);
  }
}

/// "0.5 -1 0.25 over 980.665 at 0 0.1 0.2 every 0.1"; the values are `plain` if there are none.
inline void set_values(Row& row, const std::string& told) {
  std::map<std::string, Samples> parts{{"over", {}}, {"at", {}}, {"every", {}}};
  Samples* part = &row.values;
  row.values.clear();
  std::istringstream words(told);
  for (std::string word; words >> word;) {
    if (parts.contains(word)) {
      part = &parts[word];
    } else {
      part->push_back(std::stod(word));
    }
  }
  row.values = row.values.empty() ? plain : row.values;
  for (const double over : parts["over"]) {
    std::ranges::transform(row.values, row.values.begin(), [over](double v) { return v / over; });
  }
  row.times = parts["at"];
  row.step = parts["every"].empty() ? 0 : parts["every"].front();
}

/// The rows of a file:
///   = NAME        with options such as step=0.1, units=g or channel=2
///   < TEXT        where {titles} and the like stand for the texts above; or
///   - OLD, + NEW  in the sample of that name
///     reads VALUES over NUMBER at TIMES every STEP
///     says WORDS
inline std::vector<Row> rows_of(const std::string& file) {
  std::ifstream lines(STILLPOINT_DATA_DIR "/../tests/core/records/files/" + file);
  BOOST_TEST_REQUIRE(lines.good(), file);
  std::vector<Row> rows;
  for (std::string line; std::getline(lines, line);) {
    const std::string rest = line.size() > 2 ? line.substr(2) : "";
    if (line.starts_with("= ")) {
      std::istringstream words(rest);
      words >> rows.emplace_back().name;
      for (std::string word; words >> word;) {
        set_option(rows.back().options, word);
      }
    } else if (line.starts_with("< ")) {
      std::string& text = rows.back().text = unescaped(rest);
      for (const auto& [name, stands_for] :
           std::map<std::string, std::string>{{"{header}", header},
                                              {"{titles}", titles},
                                              {"{quantity}", quantity},
                                              {"{three}", three},
                                              {"{uneven}", uneven}}) {
        for (std::size_t at = 0; (at = text.find(name)) != std::string::npos;) {
          text.replace(at, name.size(), stands_for);
        }
      }
    } else if (line.starts_with("-") || line.starts_with("+")) {
      (line.front() == '-' ? rows.back().old : rows.back().now) = unescaped(rest);
    } else if (line.starts_with("  says ")) {
      rows.back().says = unescaped(line.substr(7));
    } else if (line.starts_with("  reads")) {
      set_values(rows.back(), line.substr(7));
    }
  }
  return rows;
}

/// `text` with other ends of its lines.
inline std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) {
    result += c == '\n' ? end : std::string(1, c);
  }
  return result;
}

/// A header with another line in place of the quantity, and three values.
inline std::string measured(const std::string& line) {
  return titles + line + "\nNPTS= 3, DT= .02000 SEC\n" + three;
}

inline RecordFile file_of(const char* name, const std::string& text,
                          const RecordOptions& options = {}) {
  return records::parse_record(text, name, options);
}

inline Record record_of(const char* name, const std::string& text,
                        const RecordOptions& options = {}) {
  return file_of(name, text, options).record;
}

/// Of each row of the table, under each of the names.
inline void check_read(const std::string& table, const std::vector<const char*>& names) {
  for (const Row& row : rows_of(table)) {
    for (const char* const name : names) {
      BOOST_TEST_CONTEXT(row.name << " as " << name) {
        const Record record = record_of(name, row.text, row.options);
        BOOST_TEST(record.values == row.values, boost::test_tools::per_element());
        BOOST_TEST(record.times == row.times, boost::test_tools::per_element());
        BOOST_TEST(record.step == row.step);
      }
    }
  }
}

/// The parts of `says` between "..." must stand in the message.
inline void check_parts(const std::string& message, std::string says) {
  for (std::size_t at = 0; at != std::string::npos; says.erase(0, at + 3)) {
    at = says.find("...");
    check_says(message, {says.substr(0, at)});
    if (at == std::string::npos) {
      return;
    }
  }
}

inline void check_refused(const char* name, const Row& row) {
  const std::string message =
      refusal_of<records::FileError>([&] { return file_of(name, row.text, row.options); });
  check_parts(message, row.says);
  BOOST_TEST(message.starts_with("record " + std::string(name)), message);
}

inline void check_refused(const std::string& table, const char* name) {
  for (const Row& row : rows_of(table)) {
    BOOST_TEST_CONTEXT(row.name) {
      check_refused(name, row);
    }
  }
}

}  // namespace stillpoint::test
