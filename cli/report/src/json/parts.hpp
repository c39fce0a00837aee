// SPDX-License-Identifier: MIT
#pragma once

// The parts of which the JSON reports are made.

#include <stillpoint/core/simulation.hpp>
#include <stillpoint/design/hits.hpp>
#include <stillpoint/design/practice.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/report/report.hpp>
#include "units.hpp"

#include <nlohmann/json.hpp>

#include <numbers>
#include <optional>
#include <string>
#include <vector>

/// Null where it does not exist.
template <class Value>
struct nlohmann::adl_serializer<std::optional<Value>> {
  static void to_json(nlohmann::ordered_json& json, const std::optional<Value>& value) {
    json = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  }
};

namespace stillpoint::report {

/// The period of the spring alone, in tau.
[[nodiscard]] inline double turn(double p) {
  return 2 * std::numbers::pi / p;
}
/// A count: an integer, if a double holds it exactly.
[[nodiscard]] nlohmann::ordered_json count(const std::optional<double>& value);
/// An array of what `make` makes of each item.
template <class Items, class Make>
[[nodiscard]] nlohmann::ordered_json list_json(const Items& items, const Make& make) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& item : items) {
    list.push_back(make(item));
  }
  return list;
}

/// From the low end to the high one, which may not exist.
template <class Range>
[[nodiscard]] nlohmann::ordered_json interval_json(const Range& range) {
  return nlohmann::ordered_json::array({range.low, range.high});
}

}  // namespace stillpoint::report
