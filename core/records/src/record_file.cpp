// SPDX-License-Identifier: MIT
#include "record_reader.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/names.hpp>
#include <stillpoint/records/record_file.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stillpoint::records {

namespace {

/// A file is read in the first format that recognises it. The columns, last, take any file.
constexpr std::array formats{&at2_format, &columns_format};

constexpr Names units_names(std::to_array<Named<RecordUnits>>({
    {RecordUnits::g, "g"},
    {RecordUnits::m_per_s2, "m/s2"},
    {RecordUnits::cm_per_s2, "cm/s2"},
}));

/// A scale beyond these is a slip; products would lose digits or leave the range of a double.
constexpr double smallest_scale = 1e-100;
constexpr double largest_scale = 1e100;

void check(const RecordOptions& options) {
  if (options.step && !options.clock.holds_step(*options.step)) {
    throw InputError("record-step", *options.step, step_bounds(options.clock));
  }
  const double magnitude = std::abs(options.scale);
  if (!(magnitude >= smallest_scale && magnitude <= largest_scale)) {
    throw InputError(
        "record-scale", options.scale,
        fmt::format("must have a magnitude from {} to {}", smallest_scale, largest_scale));
  }
  require_within("gravity", options.gravity_m_per_s2, smallest_scale, largest_scale);
}

}  // namespace

RecordFile parse_record(std::string_view text, const std::string& path,
                        const RecordOptions& options) {
  check(options);
  RecordReader reader(text, path, options);
  const auto* const format = std::ranges::find_if(
      formats, [&reader](const RecordFormat* each) { return each->recognises(reader); });
  return (*format)->read(reader);
}

RecordFile read_record(const std::string& path, const RecordOptions& options) {
  check(options);
  return parse_record(read_text_file("record", path, largest_record_bytes), path, options);
}

std::string_view name(RecordUnits units) noexcept {
  return units_names.name(units);
}

std::optional<RecordUnits> parse_record_units(std::string_view name) noexcept {
  return units_names.parse(name);
}

}  // namespace stillpoint::records
