// SPDX-License-Identifier: MIT
#pragma once

#include "record_lines.hpp"

#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <cmath>
#include <string_view>

namespace stillpoint::records {

/// From what stands in the file to units of g. In g with the factor 1 no bit changes.
struct RecordScale {
  double factor{1};
  double units_per_g{1};
  double largest{largest_speed};  ///< in g; what a motion can follow, excitation.hpp

  /// The acceleration that `text`, a part of this line, stands for; refuses where it is none.
  [[nodiscard]] double read(std::string_view text, const RecordLines& lines) const {
    const ScannedNumber scanned = scan_fortran_number(text);
    const double given =
        scanned.fault == NumberFault::out_of_range ? HUGE_VAL : lines.parse_number(text);
    const double value = given * factor / units_per_g;
    if (given != 0 && !(std::isnormal(value) && std::abs(value) <= largest)) {
      lines.refuse(
          fmt::format("{} is out of range: in g it must be 0 or have a magnitude from "
                      "2.2e-308 to {:.3g}",
                      quoted(text), largest));
    }
    return value;
  }
};

}  // namespace stillpoint::records
