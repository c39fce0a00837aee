// SPDX-License-Identifier: MIT
#pragma once

#include "testing/test.hpp"

namespace stillpoint::test {

struct ReferenceRow {
  std::vector<std::string> cells;

  double operator[](std::size_t column) const {
    const std::string& text = cells.at(column);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    BOOST_TEST_REQUIRE((!text.empty() && *end == '\0'), "no number: " + text);
    return value;
  }
};

/// The rows of a table below data/reference, which quotes nothing.
inline std::vector<ReferenceRow> reference_rows(const std::string& name,
                                                const std::string& heading) {
  std::ifstream file(STILLPOINT_DATA_DIR "/reference/" + name);
  std::vector<ReferenceRow> rows;
  bool is_heading = true;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line.front() == '#') {
      continue;
    }
    if (is_heading) {
      BOOST_TEST_REQUIRE(line == heading);
    } else {
      ReferenceRow& row = rows.emplace_back();
      std::istringstream text(line + ',');
      for (std::string cell; std::getline(text, cell, ',');) {
        row.cells.push_back(cell);
      }
    }
    is_heading = false;
  }
  return rows;
}

}  // namespace stillpoint::test
