// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/design/catalogue.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::sweep {

/// This many take about a second to judge.
inline constexpr std::size_t most_parts = 100'000;
/// The longest name, in bytes.
inline constexpr std::size_t longest_part_name = 100;

/// What the values of a file mean.
struct CatalogueUnits {
  std::optional<double> p{};  ///< of the task, if it is the same for all parts
  /// Metres of the dimensionless 1; empty if the task is dimensionless.
  std::optional<double> length_m{};
  bool metres_only{false};  ///< a column delta is refused: it has no length of its own
  /// Reads a number in metres, which may have a unit; throws InputError.
  std::function<double(std::string_view)> parse_metres{};
};

/// The parts of a CSV file with a header. Its columns are name, f, and delta or delta_m, in any
/// order; others are ignored. `path` "-" is standard input. Throws records::FileError, with the
/// line, for what is wrong with the file: a missing column, a value that is not a number from 0 to
/// 1e299 or makes no valid oscillator, a name that is empty, not printable or repeated, no parts at
/// all, or more than most_parts.
[[nodiscard]] std::vector<design::Part> read_catalogue(const std::string& path,
                                                       const CatalogueUnits& units);

}  // namespace stillpoint::sweep
