// SPDX-License-Identifier: MIT

// PEER's .AT2: titles, a line that names the quantity and its units, and the line with NPTS and DT,
// which is the fourth or the seventh of most files. Then the values, any number of them in a line,
// NPTS in all; blank lines and text may follow.

#include "at2_parts.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <optional>
#include <string>

namespace stillpoint::records {

namespace {

/// NPTS must be in one of these lines, not in a comment (#).
constexpr std::size_t longest_header = 32;

struct Header {
  std::optional<At2Counts> counts;
  std::optional<RecordUnits> units;
  std::size_t units_line{0};
  std::string titles;
};

bool has_counts(std::string_view line) {
  return has_npts(line) && !trimmed(line).starts_with('#');
}

bool is_at2(RecordReader reader) {
  if (upper_case(reader.path()).ends_with(".AT2")) {
    return true;
  }
  while (reader.number() < longest_header && reader.next()) {
    if (has_counts(reader.line())) {
      return true;
    }
  }
  return false;
}

void note_units(const RecordReader& reader, Header& header) {
  const auto units = at2_units(reader);
  if (!units) {
    return;
  }
  if (header.units && *header.units != *units) {
    reader.refuse(fmt::format("units of {} contradict those of line {}, {}", name(*units),
                              header.units_line, name(*header.units)));
  }
  header.units = units;
  header.units_line = reader.number();
}

/// Leaves `reader` at the last line of the header.
Header read_header(RecordReader& reader) {
  Header header;
  while (reader.number() < longest_header && reader.next()) {
    const std::string_view line = reader.line();
    const bool is_quantity = names_quantity(line);
    if (is_quantity) {
      note_units(reader, header);
    }
    if (has_counts(line)) {
      header.counts = read_at2_counts(reader);
      return header;
    }
    const std::string_view title = trimmed(line);
    if (!is_quantity && !title.empty()) {
      header.titles += (header.titles.empty() ? "" : "; ") + std::string(title);
    }
  }
  reader.refuse(
      "NPTS and DT are missing: a PEER record has a line such as NPTS= 2000, DT= .02 SEC");
}

RecordFile read_at2(RecordReader& reader) {
  const auto [counts, units, units_line, titles] = read_header(reader);
  const std::optional<RecordUnits>& asked = reader.options().units;
  RecordFile file =
      read_described(reader, {"NPTS", counts->count}, {"DT", counts->step},
                     units.value_or(asked.value_or(RecordUnits::g)), units_line, {}, titles);
  file.assumed_g = !units && !asked;
  while (reader.next()) {
    if (has_npts(reader.line())) {
      reader.refuse("a second record begins here: a file must hold only one");
    }
  }
  return file;
}

}  // namespace

constinit const RecordFormat at2_format{"PEER", ".AT2", is_at2, read_at2};

}  // namespace stillpoint::records
