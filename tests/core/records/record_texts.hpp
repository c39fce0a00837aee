// SPDX-License-Identifier: MIT
#pragma once

// Records as text, right and wrong, for the tests of each form.

#include "testing/test.hpp"

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

/// A double as it is read back to the last bit.
inline std::string in_full(double value) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << value;
  return text.str();
}

/// A file that is right, and what it says.
struct Good {
  const char* name;
  std::string text;
  Samples values;
  double step;
  Samples times{};
  RecordOptions options{};
};

/// A file that is wrong, and what the message must say; "..." stands for anything.
struct Bad {
  const char* name;
  std::string text;
  std::string says;
  RecordOptions options{};
};

inline Good right(const char* name, std::string text, Samples values = plain, double step = 0.02,
                  Samples times = {}, const RecordOptions& options = {}) {
  return {name, std::move(text), std::move(values), step, std::move(times), options};
}

inline Bad wrong(const char* name, std::string text, std::string says,
                 const RecordOptions& options = {}) {
  return {name, std::move(text), std::move(says), options};
}

inline std::ostream& operator<<(std::ostream& stream, const Good& good) {
  return stream << good.name;
}

inline std::ostream& operator<<(std::ostream& stream, const Bad& bad) {
  return stream << bad.name;
}

inline RecordOptions with_step(double step) {
  return {.step = step};
}

inline RecordOptions with_units(RecordUnits units, double scale = 1,
                                double gravity_m_per_s2 = 9.80665) {
  return {.units = units, .scale = scale, .gravity_m_per_s2 = gravity_m_per_s2};
}

inline RecordOptions with_p(double p) {
  return {.clock = {.p = p}};
}

inline RecordOptions scaled(double scale) {
  return {.scale = scale};
}

/// `text` with other ends of its lines.
inline std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text) {
    result += c == '\n' ? end : std::string(1, c);
  }
  return result;
}

inline std::string with_crlf(const std::string& text) {
  return with_line_ends(text, "\r\n");
}

/// A header whose line with NPTS and DT is `counts`.
inline std::string counted(const std::string& counts) {
  return titles + quantity + counts + "\n";
}

/// A header with another line in place of the quantity, and three values.
inline std::string measured(const std::string& line) {
  return titles + line + "\nNPTS= 3, DT= .02000 SEC\n" + three;
}

inline std::string with_nul(std::string text) {
  text += '\0';
  return text;
}

inline RecordFile file_of(const char* name, const std::string& text,
                          const RecordOptions& options = {}) {
  return records::parse_record(text, name, options);
}

inline Record record_of(const char* name, const std::string& text,
                        const RecordOptions& options = {}) {
  return file_of(name, text, options).record;
}

inline void check_read(const char* name, const Good& good) {
  const Record record = record_of(name, good.text, good.options);
  BOOST_TEST(record.values == good.values, boost::test_tools::per_element());
  BOOST_TEST(record.times == good.times, boost::test_tools::per_element());
  BOOST_TEST(record.step == good.step);
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

inline void check_refused(const char* name, const Bad& bad) {
  const std::string message =
      refusal_of<records::FileError>([&] { return file_of(name, bad.text, bad.options); });
  check_parts(message, bad.says);
  BOOST_TEST(message.starts_with("record " + std::string(name)), message);
}

}  // namespace stillpoint::test
