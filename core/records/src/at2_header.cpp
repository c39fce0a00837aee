// SPDX-License-Identifier: MIT
#include "at2_header.hpp"

#include "at2_count_line.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

namespace stillpoint::records {

namespace {

void note_units(const RecordLines& lines, At2Header& header) {
  const auto units = header_units(lines);
  if (!units) {
    return;
  }
  if (header.units && *header.units != *units) {
    lines.refuse(fmt::format("units of {} contradict those of line {}, {}", name(*units),
                             header.units_line, name(*header.units)));
  }
  header.units = units;
  header.units_line = lines.number();
}

void note_title(std::string_view title, std::string& description) {
  if (!title.empty()) {
    description += (description.empty() ? "" : "; ") + std::string(title);
  }
}

}  // namespace

bool has_at2_header(RecordLines lines) {
  while (lines.number() < longest_at2_header && lines.next()) {
    if (!trimmed(lines.line()).starts_with('#') && has_npts(lines.line())) {
      return true;
    }
  }
  return false;
}

At2Header read_at2_header(RecordLines& lines) {
  constexpr std::size_t longest_description = 200;
  At2Header header;
  while (lines.number() < longest_at2_header && lines.next()) {
    const std::string_view line = lines.line();
    const bool is_quantity = names_quantity(line);
    if (is_quantity) {
      note_units(lines, header);
    }
    if (has_npts(line) && !trimmed(line).starts_with('#')) {
      const At2Counts counts = read_at2_counts(lines);
      header.count = counts.count;
      header.step = counts.step;
      header.line = lines.number();
      header.description = printable(header.description, longest_description);
      return header;
    }
    if (!is_quantity) {
      note_title(trimmed(line), header.description);
    }
  }
  lines.refuse(
      "no NPTS and DT up to here: a PEER record has a line such as NPTS= 2000, DT= .02 SEC");
}

}  // namespace stillpoint::records
