// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace stillpoint::bench {

/// Where and with what the figures were measured.
struct Machine {
  std::string processor;
  unsigned cores{0};
  std::string system;
  std::string compiler;
  std::string flags;
  std::vector<std::string> libraries;  ///< "GSL 2.7.1"
  std::string date;                    ///< 2026-01-31
};

[[nodiscard]] Machine this_machine();

}  // namespace stillpoint::bench
