// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::sweep {

/// A flat JSON object of numbers.
struct JsonRow {
  std::vector<std::pair<std::string, double>> fields;  ///< each key once
  std::string error;                                   ///< what is wrong; empty if nothing is
};

[[nodiscard]] JsonRow parse_json_row(std::string_view text);

}  // namespace stillpoint::sweep
