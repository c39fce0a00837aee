// SPDX-License-Identifier: MIT

// Numerical stability: computes each hard case by the program, by the naive formula and in 50
// digits. Prints the page docs/accuracy.md, or writes it.

#include "finding.hpp"
#include "page.hpp"

#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace stillpoint::accuracy {

namespace {

Section section(const std::string& heading, const std::vector<HardCase>& cases) {
  Section result{heading, {}};
  for (const HardCase& now : cases) {
    fmt::print(stderr, "accuracy: {}\n", now.name);
    result.rows.push_back({now, examine(now)});
  }
  return result;
}

int run(int count, char** arguments) {
  const std::string text =
      page({section("Free motion", free_cases()), section("Admissible region", region_cases()),
            section("Forced motion", forced_cases())});
  if (count < 2) {
    fmt::print("{}", text);
    return 0;
  }
  std::ofstream file(arguments[1], std::ios::binary);
  file << text << std::flush;
  if (!file) {
    throw std::runtime_error(std::string(arguments[1]) + " could not be written");
  }
  return 0;
}

}  // namespace

}  // namespace stillpoint::accuracy

int main(int count, char** arguments) {
  try {
    return stillpoint::accuracy::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "accuracy: {}\n", error.what());
    return 1;
  }
}
