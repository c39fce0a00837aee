// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"

#include <string>
#include <vector>

namespace stillpoint::cli {

/// A sentence for each doubt about the values, and for each file in a folder of records that is
/// skipped. Throws FileError.
[[nodiscard]] std::vector<std::string> warnings(const Settings& settings, Command command);

}  // namespace stillpoint::cli
