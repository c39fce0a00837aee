// SPDX-License-Identifier: MIT
#pragma once

#include "figure_facts.hpp"

#include <optional>

namespace stillpoint::browser_test {

/// "name: x, y", or without a name.
struct Readout {
  std::string name;
  double x;
  double y;
};

inline std::optional<Readout> parsed(const std::string& text) {
  static const std::regex form(R"((?:(.*): )?([-+.e\d]+), ([-+.e\d]+))");
  std::smatch parts;
  if (!std::regex_match(text, parts, form)) {
    return {};
  }
  return Readout{parts[1], std::stod(parts[2]), std::stod(parts[3])};
}

/// Where the values of the readout lie by the ticks.
inline nlohmann::json place(const Readout& readout, const nlohmann::json& state) {
  return {TickedAxis(state, "x").place(readout.x), TickedAxis(state, "y").place(readout.y)};
}

/// The values shown are within this many pixels of the pointer, and so is the ring around them.
inline std::optional<Readout> check_shown(const nlohmann::json& hover, const nlohmann::json& state,
                                          double pixels) {
  auto readout = parsed(hover["readout"]);
  BOOST_TEST(readout.has_value(), hover.dump());
  if (readout) {
    check_near(place(*readout, state), hover["pointer"], pixels);
  }
  if (!hover["ring"].is_null()) {
    check_near(hover["ring"], hover["pointer"], pixels);
  }
  return readout;
}

}  // namespace stillpoint::browser_test
