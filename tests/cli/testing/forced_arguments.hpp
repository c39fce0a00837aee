// SPDX-License-Identifier: MIT
#pragma once

#include "run_program.hpp"

#include <cmath>

namespace stillpoint::cli_test {

/// A mass at rest, to be shaken.
inline Arguments at_rest(const Arguments& more) {
  return "simulate --p 1 --f 0.1 --delta 0.01" + more;
}

inline Arguments pulse(const char* type, const Arguments& more = {}) {
  return at_rest(Arguments{"--excitation", type, "--k", "0.5", "--lambda", "2"} + more);
}

inline const Arguments harmonic = pulse("harmonic", "--t-end 20");

/// Scene S4, with stops.
inline const Arguments s4(
    "simulate --v0 0.5 --p 1 --f 0.18 --delta 0 --excitation harmonic --k 0.2 --lambda 0.35 "
    "--t-end 200");

using Row = std::vector<double>;

/// Rows of numbers, as a record file has them.
inline std::string column_file(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    for (const double value : row) {
      text += in_full(value) + " ";
    }
    text += "\n";
  }
  return text;
}

/// The record of scene S5: two wave packets, 3000 samples every 0.02, without times.
inline std::vector<Row> record_s5(double scale = 1) {
  std::vector<Row> rows;
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 0.02;
    rows.push_back({scale * (0.4 * std::exp(-std::pow((t - 20) / 10, 2)) * std::sin(2.3 * t) +
                             0.2 * std::exp(-std::pow((t - 25) / 12, 2)) * std::sin(5.1 * t + 1))});
  }
  return rows;
}

inline const Arguments s5("simulate --p 1 --f 0.05 --delta 0 --record s5.txt");

}  // namespace stillpoint::cli_test
