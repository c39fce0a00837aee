// SPDX-License-Identifier: MIT

// The COSMOS format, version 1.20 (.V2c; CESMD, USGS). Each block of acceleration, velocity or
// displacement has its own headers: lines of text, whole numbers, reals and comments. The step is
// the real number 34, in s, and the line above the values has the rest:
//
//     2000 acceleration pts, approx  20 secs, units=cm/sec2(04),Format=(8F10.5)

#include "acceleration_units.hpp"
#include "channel.hpp"
#include "value_block.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cmath>

namespace stillpoint::records {

namespace {

bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

bool begins_cosmos_channel(std::string_view line) {
  const std::string text = upper_case(line);
  return has(text, "ACCEL") && has(text, "PTS") && has(text, "UNITS=");
}

bool is_cosmos(RecordReader reader) {
  return reader.next() && has(upper_case(reader.line()), "(FORMAT V");
}

struct CosmosTime {
  double step{0};
  double length{0};     ///< of the record; not above 0: not given
  std::size_t line{0};  ///< of both
};

/// The real numbers 34 and 35 of the last header above `end`.
CosmosTime cosmos_time(RecordReader start, const RecordReader& end) {
  constexpr std::size_t step_number = 34;
  std::optional<RecordReader> header;
  while (start.number() < end.number() && start.next()) {
    if (has(upper_case(start.line()), "REAL-HEADER VALUES")) {
      header = start;
    }
  }
  if (!header) {
    end.refuse("no Real-header values up to here: number 34 of them is the step");
  }
  const std::size_t width = field_width(header->line());
  CosmosTime time;
  std::size_t count = 0;
  while (count <= step_number && header->next() && header->number() < end.number()) {
    for (const std::string_view field : fields_of(header->line(), width)) {
      ++count;
      if (count == step_number) {
        time.step = header->parse_number(field);
        time.line = header->number();
      } else if (count == step_number + 1) {
        time.length = header->parse_number(field);
      }
    }
  }
  if (count < step_number) {
    end.refuse(fmt::format("only {} Real-header values up to here: number 34 is the step", count));
  }
  return time;
}

/// A factor of 1000 between s and ms must not slip through.
void check_length(const RecordReader& reader, const CosmosTime& time, std::size_t count) {
  const double length = static_cast<double>(count) * time.step;
  if (time.length > 0 && std::abs(length - time.length) > time.length / 100 + time.step) {
    reader.refuse(time.line, fmt::format("{} points of {} s, Real-header value 34, are {} s, but "
                                         "value 35 says {} s",
                                         count, time.step, length, time.length));
  }
}

/// cm/sec2 of units=cm/sec2(04).
std::string_view cosmos_units(std::string_view line) {
  const std::size_t at = upper_case(line).find("UNITS=") + std::string_view("UNITS=").size();
  const std::string_view rest = line.substr(at);
  return trimmed(rest.substr(0, rest.find_first_of(",(")));
}

RecordFile read_cosmos(RecordReader& reader) {
  const RecordReader start = reader;
  go_to_channel(reader, begins_cosmos_channel);
  std::string_view rest = reader.line();
  const std::string_view count = take_word(rest);
  const ValueBlock block{"the count of points",
                         whole_count(reader, "points", count, reader.parse_number(count)),
                         reader.number(), field_width(reader.line())};
  const RecordUnits units = read_units(reader, cosmos_units(reader.line()));
  const CosmosTime time = cosmos_time(start, reader);
  const double tau = reader.file_step(time.line, "Real-header value 34, the step,", time.step);
  check_length(reader, time, block.count);
  reader.set_units(units, reader.number());
  const std::string description =
      last_line_with(start, reader, "Stat") + "; " + last_line_with(start, reader, "Sta Chan");
  return {{read_block(reader, block, acceleration_field), tau, {}},
          printable(description, longest_description),
          units};
}

}  // namespace

constinit const RecordFormat cosmos_format{is_cosmos, read_cosmos, true};

}  // namespace stillpoint::records
