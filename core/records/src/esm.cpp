// SPDX-License-Identifier: MIT

// The ASCII files of the European strong-motion databases ESM and ITACA, header DYNA: lines "KEY:
// value", 64 of them in DYNA 1.2 and 55 in DYNA 1.0, then one value a line, NDATA in all.

#include "acceleration_units.hpp"
#include "channel.hpp"
#include "value_block.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <optional>

namespace stillpoint::records {

namespace {

struct EsmHeader {
  std::optional<double> step;
  std::size_t step_line{0};
  ValueBlock block{.count_name = "NDATA"};
  std::optional<RecordUnits> units;
  std::size_t units_line{0};
  std::string description;
};

bool is_esm(RecordReader reader) {
  return reader.next() && reader.line().starts_with("EVENT_NAME:");
}

/// The keys that matter, and those that describe the record.
void note_esm_key(const RecordReader& reader, std::string_view key, std::string_view value,
                  EsmHeader& header) {
  if (key == "SAMPLING_INTERVAL_S") {
    header.step = reader.parse_number(value);
    header.step_line = reader.number();
  } else if (key == "NDATA") {
    header.block.count = whole_count(reader, key, value, reader.parse_number(value));
    header.block.count_line = reader.number();
  } else if (key == "UNITS") {
    header.units = read_units(reader, value);
    header.units_line = reader.number();
  } else if (key == "DATA_TYPE" && upper_case(value) != "ACCELERATION") {
    reader.refuse(fmt::format("DATA_TYPE is {}: must be ACCELERATION", quoted(value)));
  } else if (key == "EVENT_NAME" || key == "NETWORK" || key == "STATION_CODE" || key == "STREAM") {
    header.description += " " + std::string(value);
  }
}

/// Stops before the first line that has no key.
EsmHeader read_esm_header(RecordReader& reader) {
  EsmHeader header;
  for (RecordReader ahead = reader; ahead.next(); reader = ahead) {
    const std::size_t colon = ahead.line().find(':');
    if (colon == std::string_view::npos) {
      break;
    }
    const std::string_view value = trimmed(ahead.line().substr(colon + 1));
    if (!value.empty()) {
      note_esm_key(ahead, ahead.line().substr(0, colon), value, header);
    }
  }
  for (const auto& [key, found] :
       {std::pair{"SAMPLING_INTERVAL_S", header.step.has_value()},
        std::pair{"NDATA", header.block.count > 0}, std::pair{"UNITS", header.units.has_value()}}) {
    if (!found) {
      reader.refuse(fmt::format("the header ends here without {}", key));
    }
  }
  return header;
}

RecordFile read_esm(RecordReader& reader) {
  const EsmHeader header = read_esm_header(reader);
  const double step = reader.file_step(header.step_line, "SAMPLING_INTERVAL_S", *header.step);
  reader.set_units(*header.units, header.units_line);
  return {{read_block(reader, header.block, acceleration_field), step, {}},
          printable(single_spaced(header.description), longest_description),
          *header.units};
}

}  // namespace

constinit const RecordFormat esm_format{is_esm, read_esm};

}  // namespace stillpoint::records
