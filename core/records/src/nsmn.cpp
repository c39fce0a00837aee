// SPDX-License-Identifier: MIT

// The ASCII files of the Turkish network (AFAD, TR-NSMN): 18 lines of text, of which the thirteenth
// counts the rows and the fourteenth has the step in s, then accelerations in gal in the columns
// N-S, E-W and U-D. The newer files of AFAD's TADAS are those of ESM.

#include "channel.hpp"

#include <stillpoint/records/text.hpp>

#include <array>

namespace stillpoint::records {

namespace {

bool is_nsmn(RecordReader reader) {
  return reader.next() &&
         upper_case(reader.line()).find("STRONG GROUND MOTION RECORDS OF T") != std::string::npos;
}

RecordFile read_nsmn(RecordReader& reader) {
  constexpr std::array columns{"N-S", "E-W", "U-D"};
  constexpr std::size_t place_line = 2;
  constexpr std::size_t count_line = 13;
  constexpr std::size_t titles = 18;
  skip(reader, place_line);
  std::string description(after_colon(reader.line()));
  skip(reader, count_line - place_line);
  const HeaderText count{after_colon(reader.line()), reader};
  skip(reader, 1);
  const HeaderText step{after_colon(reader.line()), reader};
  skip(reader, titles - step.reader.number());
  const std::size_t wanted =
      chosen_channel(reader, columns.size(), "the columns are N-S, E-W and U-D");
  return read_described(reader, {"NUMBER OF DATA", count}, {"SAMPLING INTERVAL", step},
                        RecordUnits::cm_per_s2, step.reader.number(),
                        {.columns = columns.size(), .column = wanted},
                        description + ", " + columns.at(wanted));
}

}  // namespace

constinit const RecordFormat nsmn_format{"AFAD", "", is_nsmn, read_nsmn, true};

}  // namespace stillpoint::records
