// SPDX-License-Identifier: MIT
#pragma once

#include <boost/test/unit_test.hpp>

#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::test {

[[nodiscard]] inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

inline void check_contains(std::string_view text, const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    BOOST_TEST(contains(text, part), "no " << part << " in\n" << text);
  }
}

/// Without the breaks and the indents of a report.
[[nodiscard]] inline std::string one_line(const std::string& text) {
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

}  // namespace stillpoint::test
