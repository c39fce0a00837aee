// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::cli {

/// A flat JSON object of numbers.
struct JsonRow {
  std::vector<std::pair<std::string, double>> fields;  ///< no key stands twice
  std::string error;                                   ///< what is wrong with it; empty: nothing
};

[[nodiscard]] JsonRow parse_json_row(std::string_view text);

}  // namespace stillpoint::cli
