// SPDX-License-Identifier: MIT

// The ASCII files of the European strong-motion databases ESM and ITACA, header DYNA: lines "KEY:
// value", 64 of them in DYNA 1.2 and 55 in DYNA 1.0, then one value a line, NDATA in all.

#include "acceleration_units.hpp"
#include "channel.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <vector>

namespace stillpoint::records {

namespace {

bool is_esm(RecordReader reader) {
  return reader.next() && reader.line().starts_with("EVENT_NAME:");
}

RecordFile read_esm(RecordReader& reader) {
  std::vector<RecordReader> header;
  for (RecordReader ahead = reader;
       ahead.next() && ahead.line().find(':') != std::string_view::npos; reader = ahead) {
    header.push_back(ahead);
  }
  const auto type = find_key(header, "DATA_TYPE:");
  if (type && upper_case(type->text) != "ACCELERATION") {
    type->reader.refuse(fmt::format("DATA_TYPE is {}: must be ACCELERATION", quoted(type->text)));
  }
  const auto [unit, unit_line] = text_of(header, "UNITS:");
  return read_described(reader, {"NDATA", text_of(header, "NDATA:")},
                        {"SAMPLING_INTERVAL_S", text_of(header, "SAMPLING_INTERVAL_S:")},
                        read_units(unit_line, unit), unit_line.number(), {},
                        described(header, {"EVENT_NAME:", "NETWORK:", "STATION_CODE:", "STREAM:"}));
}

}  // namespace

constinit const RecordFormat esm_format{"ESM", ".ASC", is_esm, read_esm};

}  // namespace stillpoint::records
