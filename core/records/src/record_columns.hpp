// SPDX-License-Identifier: MIT
#pragma once

#include "record_clock.hpp"
#include "record_lines.hpp"
#include "record_scale.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace stillpoint::records {

/// Time and value, or value alone.
struct RecordColumns {
  std::vector<double> times;  ///< from 0 on, increasing; empty where there are values alone
  std::vector<double> values;
  std::string description;    ///< the first comment
  std::size_t first_line{0};  ///< that holds values
};

/// One or two columns between blanks, tabs or commas. What follows a # is a comment; blank lines
/// are passed over.
[[nodiscard]] RecordColumns read_columns(RecordLines& lines, const RecordScale& scale,
                                         const RecordClock& clock);

/// The step h = t_1 of times that are 0, h, 2 h, ... but for the rounding of doubles:
///
///     t_0 = 0  and  |t_i - i h| <= 2^-51 t_i  for every i.
///
/// A decimal time is off its double by 2^-53, relative; so is h, and so is the product. The bound
/// leaves room for these three and no more: with the step no time moves further than two units in
/// its last place. Otherwise 0: times that were rounded to fewer digits (0, 0.0333, 0.0667) stay as
/// they are.
[[nodiscard]] double uniform_step(const std::vector<double>& times);

}  // namespace stillpoint::records
