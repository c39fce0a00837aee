// SPDX-License-Identifier: MIT
#include "record_file.hpp"

#include "at2_header.hpp"
#include "at2_values.hpp"
#include "record_columns.hpp"
#include "record_lines.hpp"
#include "record_scale.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/records/text_file.hpp>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace stillpoint::records {

namespace {

/// Beyond these a scale is a slip, and products lose digits or leave the range of a double.
constexpr double smallest_scale = 1e-100;
constexpr double largest_scale = 1e100;

bool holds_step(const RecordClock& clock, double step) {
  return clock.reaches(step) && clock.tells_apart(0, step);
}

std::string out_of_reach(const RecordClock& clock) {
  return fmt::format("must be from {:.3g} to {:.3g} {}", clock.shortest(), clock.latest(),
                     clock.unit);
}

void check(const RecordOptions& options) {
  if (options.step && !holds_step(options.clock, *options.step)) {
    throw InputError("record-step", *options.step, out_of_reach(options.clock));
  }
  const double magnitude = std::abs(options.scale);
  if (!(magnitude >= smallest_scale && magnitude <= largest_scale)) {
    throw InputError(
        "record-scale", options.scale,
        fmt::format("must have a magnitude from {} to {}", smallest_scale, largest_scale));
  }
  require_within("gravity", options.gravity_m_per_s2, smallest_scale, largest_scale);
}

double units_per_g(RecordUnits units, double gravity_m_per_s2) {
  switch (units) {
    case RecordUnits::g:
      break;
    case RecordUnits::m_per_s2:
      return gravity_m_per_s2;
    case RecordUnits::cm_per_s2:
      return 100 * gravity_m_per_s2;
  }
  return 1;
}

RecordScale scale_for(const RecordOptions& options, std::optional<RecordUnits> units) {
  return {options.scale, units_per_g(units.value_or(RecordUnits::g), options.gravity_m_per_s2),
          options.clock.largest_load()};
}

/// A step for a file that has its own.
void refuse_step(const RecordOptions& options, const RecordLines& lines, std::size_t line,
                 std::string_view what) {
  if (options.step) {
    lines.refuse(line,
                 fmt::format("{}, so record-step = {} must not be given", what, *options.step));
  }
}

RecordFile read_at2(RecordLines& lines, const RecordOptions& options) {
  At2Header header = read_at2_header(lines);
  refuse_step(options, lines, header.line, "DT stands here");
  if (!holds_step(options.clock, header.step)) {
    lines.refuse(header.line, fmt::format("DT = {}: {}", header.step, out_of_reach(options.clock)));
  }
  if (header.units && options.units && *header.units != *options.units) {
    lines.refuse(header.units_line,
                 fmt::format("the values are in {}, which record-units = {} contradicts",
                             name(*header.units), name(*options.units)));
  }
  const RecordScale scale = scale_for(options, header.units ? header.units : options.units);
  return {read_at2_values(lines, header, scale), header.step, {}, std::move(header.description)};
}

RecordFile read_plain(RecordLines& lines, const RecordOptions& options) {
  RecordColumns columns = read_columns(lines, scale_for(options, options.units), options.clock);
  RecordFile record{std::move(columns.values), 0, {}, std::move(columns.description)};
  if (columns.times.empty()) {
    if (!options.step) {
      throw InputError::missing(
          "record-step", fmt::format("record {}, line {}: values without times need the step in {}",
                                     lines.path(), columns.first_line, options.clock.unit));
    }
    record.step = *options.step;
    return record;
  }
  refuse_step(options, lines, columns.first_line, "times stand beside the values");
  record.step = uniform_step(columns.times);
  if (record.step == 0) {
    record.times = std::move(columns.times);
  }
  return record;
}

}  // namespace

RecordFile read_record(const std::string& path, const RecordOptions& options) {
  check(options);
  const std::string text = read_text_file("record", path, largest_record_bytes);
  RecordLines lines(path, text);
  const bool is_at2 = upper_case(path).ends_with(".AT2") || has_at2_header(lines);
  return is_at2 ? read_at2(lines, options) : read_plain(lines, options);
}

}  // namespace stillpoint::records
