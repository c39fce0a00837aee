// SPDX-License-Identifier: MIT

// The accelerograms of GeoNet, New Zealand: V1A, uncorrected, and V2A, corrected. For each of three
// components 16 lines of text, 40 whole numbers and 60 reals, then accelerations in mm/s2, and in a
// V2A velocities and displacements; all numbers are ten in a line, in fields of 8. Whole number 34,
// in a V1A 31, counts the accelerations, and real number 26 is the step in s.

#include "channel.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cmath>

namespace stillpoint::records {

namespace {

constexpr std::size_t geonet_width = 8;

bool begins_geonet_channel(std::string_view line) {
  const std::string text = upper_case(trimmed(line));
  return text.starts_with("UNCORRECTED ACCELEROGRAM") || text.starts_with("CORRECTED ACCELEROGRAM");
}

/// "Corrected accelerogram 20160214_001343_NBLC_20 GNS Science", then "Site NBLC  43 30 25S ...".
bool is_geonet(RecordReader reader) {
  return reader.next() && begins_geonet_channel(reader.line()) && reader.next() &&
         upper_case(trimmed(reader.line())).starts_with("SITE ");
}

/// Velocities and displacements stand below the accelerations.
void check_geonet_lines(RecordReader reader, const RecordReader& numbers) {
  constexpr double per_line = 10;
  double expected = 0;
  for (const std::size_t count : {35U, 36U}) {
    expected += std::ceil(value_of(header_number(numbers, 4, geonet_width, count)) / per_line);
  }
  double lines = 0;
  while (reader.next() && !begins_geonet_channel(reader.line())) {
    lines += trimmed(reader.line()).empty() ? 0 : 1;
  }
  if (lines != expected) {
    reader.refuse(
        fmt::format("{} lines stand between the accelerations and here, but the whole "
                    "numbers 35 and 36 make {}",
                    lines, expected));
  }
}

RecordFile read_geonet(RecordReader& reader) {
  constexpr std::size_t titles = 16;
  constexpr std::size_t component = 13;
  constexpr std::size_t integer_lines = 4;
  constexpr std::size_t real_lines = 6;
  go_to_channel(reader, begins_geonet_channel);
  const bool raw = upper_case(trimmed(reader.line())).starts_with("UN");
  std::string description = single_spaced(reader.line());
  skip(reader, component - 1);
  description += "; " + single_spaced(reader.line());
  skip(reader, titles - component);
  const RecordReader numbers = reader;
  const HeaderText count = header_number(reader, integer_lines, geonet_width, raw ? 31 : 34);
  skip(reader, integer_lines);
  const HeaderText step = header_number(reader, real_lines, geonet_width, 26);
  skip(reader, real_lines);
  RecordFile file = read_described(reader, {raw ? "whole number 31" : "whole number 34", count},
                                   {"real number 26, the step,", step}, RecordUnits::mm_per_s2,
                                   count.reader.number(),
                                   {.width = geonet_width, .others_follow = true}, description);
  check_geonet_lines(reader, numbers);
  return file;
}

}  // namespace

constinit const RecordFormat geonet_format{"GeoNet", ".V1A .V2A", is_geonet, read_geonet, true};

}  // namespace stillpoint::records
