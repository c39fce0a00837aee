// SPDX-License-Identifier: MIT
#pragma once

#include "options/settings.hpp"
#include "result.hpp"

#include <memory>

namespace stillpoint::python {

/// The part of a design under records that the settings ask for, also in its file.
[[nodiscard]] std::unique_ptr<Result> design_part(cli::Settings settings);

}  // namespace stillpoint::python
