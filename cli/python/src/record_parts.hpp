// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"
#include "result.hpp"

#include <memory>
#include <string>
#include <vector>

namespace stillpoint::python {

/// The design under records of all its parts.
[[nodiscard]] std::unique_ptr<Result> merged_design(const std::vector<std::string>& parts);

/// The part of a design under records that the settings ask for, also in its file.
[[nodiscard]] std::unique_ptr<Result> design_part(cli::Settings settings);

}  // namespace stillpoint::python
