// SPDX-License-Identifier: MIT

// The text files of the Taiwanese network (CWB, now CWA): lines "#Key: value", then rows of the
// time in s and the accelerations upwards, to the north and to the east, as #DataSequence says.

#include "acceleration_units.hpp"
#include "channel.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <vector>

namespace stillpoint::records {

namespace {

constexpr std::string_view cwb_rate = "#SampleRate(Hz):";

std::vector<RecordReader> cwb_header(RecordReader reader) {
  std::vector<RecordReader> header;
  while (reader.next() && (reader.line().starts_with('#') || trimmed(reader.line()).empty())) {
    header.push_back(reader);
  }
  return header;
}

bool is_cwb(RecordReader reader) {
  const auto header = cwb_header(reader);
  return !header.empty() && find_key(header, cwb_rate);
}

std::string rows_below(RecordReader reader) {
  std::size_t rows = 0;
  while (reader.next()) {
    rows += trimmed(reader.line()).empty() ? 0U : 1U;
  }
  return std::to_string(rows);
}

RecordFile read_cwb(RecordReader& reader) {
  const auto header = cwb_header(reader);
  reader = header.back();
  const HeaderText rate = text_of(header, cwb_rate);
  HeaderText unit = text_of(header, "#AmplitudeUnit:");
  const HeaderText sequence = text_of(header, "#DataSequence:");
  const auto names = words_of(sequence.text, " ;,\t");  // Time U(+); N(+); E(+)
  const std::size_t wanted = 1 + chosen_channel(reader, names.size() - 1,
                                                fmt::format("the columns are {}", sequence.text));
  const std::string rows = rows_below(reader);
  const RecordUnits units = read_units(unit.reader, take_word(unit.text));
  return read_described(
      reader, {"the rows", {rows, reader}}, {"1 over the SampleRate", rate, 1 / value_of(rate)},
      units, unit.reader.number(), {.columns = names.size(), .column = wanted},
      fmt::format("{}, {}", described(header, {"#StationCode:", "#StartTime:"}), names[wanted]));
}

}  // namespace

constinit const RecordFormat cwb_format{"CWA", "", is_cwb, read_cwb, true};

}  // namespace stillpoint::records
