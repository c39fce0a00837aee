// SPDX-License-Identifier: MIT
#pragma once

#include "record_clock.hpp"
#include "record_units.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace stillpoint::records {

/// An acceleration over time, from a file. docs/records.md describes the formats.
struct RecordFile {
  std::vector<double> values;  ///< in units of g, scaled; at least one
  double step{0};              ///< in the clock's unit; 0 where `times` are given
  std::vector<double>
      times;  ///< likewise, increasing, as many as values; empty where there is a step
  std::string description;  ///< titles of a PEER record or the first comment; may be empty
};

struct RecordOptions {
  std::optional<double> step{};  ///< in the clock's unit, of a file with values alone; more than 0
  /// Of the file. Where not given: what a PEER header says, else g.
  std::optional<RecordUnits> units{};
  double scale{1};                   ///< on every value; negative reverses it; not 0
  double gravity_m_per_s2{9.80665};  ///< one g of the result
  RecordClock clock{};
};

constexpr std::size_t largest_record_bytes = std::size_t{64} << 20U;

/// Reads a PEER .AT2 record, or columns: time and value, or value alone. A file is taken for PEER
/// where its name ends in .at2 or one of its first 32 lines has the word NPTS.
///
/// Throws FileError, with the number of the line, where the file is not in order or contradicts
/// the options, and InputError for a wrong or missing option.
[[nodiscard]] RecordFile read_record(const std::string& path, const RecordOptions& options = {});

}  // namespace stillpoint::records
