// SPDX-License-Identifier: MIT
#pragma once

#include "record_lines.hpp"

#include <cmath>
#include <string_view>

namespace stillpoint::cli {

/// From what stands in the file to units of g. In g with the factor 1 no bit changes.
struct RecordScale {
  double factor{1};
  double units_per_g{1};

  /// The acceleration that `text`, a part of this line, stands for; refuses where it is none.
  [[nodiscard]] double read(std::string_view text, const RecordLines& lines) const {
    const double given = lines.parse_number(text);
    const double value = given * factor / units_per_g;
    if (given != 0 && !std::isnormal(value)) {
      lines.refuse(quoted(text) + " is out of range once it is scaled");
    }
    return value;
  }
};

}  // namespace stillpoint::cli
