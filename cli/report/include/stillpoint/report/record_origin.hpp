// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace stillpoint::report {

/// Where an acceleration record comes from.
struct RecordOrigin {
  std::string file;
  std::string description;           ///< what the file says of itself
  std::optional<std::string> units;  ///< these three as asked for
  std::optional<double> step;
  std::optional<double> scale;
};

}  // namespace stillpoint::report
