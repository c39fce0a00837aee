// SPDX-License-Identifier: MIT
#include "json/parts.hpp"

#include <stillpoint/records/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace stillpoint::report {

using nlohmann::ordered_json;

namespace {

/// Any other number would be written as null.
[[maybe_unused]] bool is_finite(const ordered_json& json) {
  return json.is_structured() ? std::ranges::all_of(json, is_finite)
                              : !json.is_number_float() || std::isfinite(json.get<double>());
}

}  // namespace

std::string json_text(const ordered_json& json) {
  constexpr int spaces = 2;
  assert(is_finite(json));
  // A terminal may show it: controls beyond ASCII are escaped too.
  const auto escaped = [](unsigned code) {
    return code == '\n' ? "\n" : fmt::format("\\u{:04x}", code);
  };
  return records::with_controls_as(escaped, json.dump(spaces)) + "\n";
}

ordered_json count(const std::optional<double>& value) {
  constexpr double exact = 9007199254740992;  // 2^53
  if (value && *value <= exact) {
    return static_cast<std::int64_t>(*value);
  }
  return value;
}

}  // namespace stillpoint::report
