// SPDX-License-Identifier: MIT

// The COSMOS format, version 1.20 (.V2c; CESMD, USGS). Each block of acceleration, velocity or
// displacement has its own headers: lines of text, whole numbers, reals and comments. The step is
// the real number 62, in ms, and the line above the values has the rest:
//
//     2000 acceleration pts, approx  20 secs, units=cm/sec2(04),Format=(8F10.5)
//
// Number 34 is the step of the recorder, in s. Processing may have changed it, so it counts only
// where number 62 is not given.

#include "acceleration_units.hpp"
#include "channel.hpp"
#include "value_block.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace stillpoint::records {

namespace {

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

bool begins_cosmos_channel(std::string_view line) {
  const std::string text = upper_case(line);
  return has(text, "ACCEL") && (has(text, "PTS") || has(text, "POINTS")) && has(text, "UNITS=");
}

bool is_cosmos(RecordReader reader) {
  return reader.next() && has(upper_case(reader.line()), "(FORMAT V");
}

/// The fields of the last real header above `end`, and what stands below it.
std::vector<HeaderText> real_header(RecordReader start, const RecordReader& end) {
  std::optional<RecordReader> header;
  while (start.number() < end.number() && start.next()) {
    if (has(upper_case(start.line()), "REAL-HEADER VALUES")) {
      header = start;
    }
  }
  if (!header) {
    end.refuse("Real-header values are missing: number 62 or 34 of them is the step");
  }
  return fields_below(*header, end.number() - 1, field_width(header->line()));
}

/// A value of the real header. Unknown ones are not above 0, usually -999.
struct RealValue {
  std::size_t number{0};  ///< from 1; 0: the header ends before
  double value{0};
  std::optional<HeaderText> given{};
};

RealValue real_value(const std::vector<HeaderText>& header, std::size_t number) {
  if (number > header.size()) {
    return {};
  }
  return {number, value_of(header[number - 1]), header[number - 1]};
}

/// The step and the length in s, of the values or else of the recorder.
struct CosmosTime {
  RealValue step;
  RealValue length;
};

CosmosTime cosmos_time(const RecordReader& start, const RecordReader& end) {
  const std::vector<HeaderText> header = real_header(start, end);
  const RealValue raw_step = real_value(header, 34);
  if (raw_step.number == 0) {
    end.refuse(
        fmt::format("only {} Real-header values: number 62 or 34 must be the step", header.size()));
  }
  const RealValue step = real_value(header, 62);
  const RealValue length = real_value(header, 63);
  constexpr double ms = 1000;
  const bool is_given = step.value > 0;
  return {is_given ? RealValue{step.number, step.value / ms, step.given} : raw_step,
          is_given && length.value > 0 ? length : real_value(header, 35)};
}

/// A factor of 1000 between s and ms must not slip through.
void check_length(const RecordReader& reader, const CosmosTime& time, double count) {
  const auto& [step, length] = time;
  const double taken = count * step.value;
  if (step.value > 0 && length.value > 0 &&
      std::abs(taken - length.value) > length.value / 100 + step.value) {
    reader.refuse(
        step.given->reader.number(),
        fmt::format("{} points of {} s (Real-header value {}) take {} s, but value {} says {} s",
                    count, step.value, step.number, taken, length.number, length.value));
  }
}

/// cm/sec2 of units=cm/sec2(04), and g of units=g.     (02).
std::string_view cosmos_units(std::string_view line) {
  const std::size_t at = upper_case(line).find("UNITS=") + std::string_view("UNITS=").size();
  const std::string_view rest = line.substr(at);
  const std::string_view units = trimmed(rest.substr(0, rest.find_first_of(",(")));
  return units.substr(0, units.find_last_not_of('.') + 1);
}

RecordFile read_cosmos(RecordReader& reader) {
  const RecordReader start = reader;
  go_to_channel(reader, begins_cosmos_channel);
  std::string_view rest = reader.line();
  const HeaderText count{take_word(rest), reader};
  const RecordUnits units = read_units(reader, cosmos_units(reader.line()));
  const CosmosTime time = cosmos_time(start, reader);
  check_length(reader, time, value_of(count));
  const std::string step_name = fmt::format("Real-header value {}, the step,", time.step.number);
  return read_described(reader, {"the count of points", count},
                        {step_name, *time.step.given, time.step.value}, units, reader.number(),
                        {.width = field_width(reader.line())},
                        described(start, reader, "Stat", "Sta Chan"));
}

}  // namespace

constinit const RecordFormat cosmos_format{"COSMOS", ".V2C", is_cosmos, read_cosmos, true};

}  // namespace stillpoint::records
