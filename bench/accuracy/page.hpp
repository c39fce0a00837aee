// SPDX-License-Identifier: MIT
#pragma once

#include "finding.hpp"
#include "hard_case.hpp"

#include <string>
#include <vector>

namespace stillpoint::accuracy {

struct Row {
  HardCase hard_case;
  Finding finding;
};

struct Section {
  std::string heading;
  std::vector<Row> rows;
};

/// docs/accuracy.md
[[nodiscard]] std::string page(const std::vector<Section>& sections);

}  // namespace stillpoint::accuracy
