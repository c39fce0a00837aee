// SPDX-License-Identifier: MIT
#pragma once

#include "settings.hpp"

#include <string>
#include <vector>

namespace stillpoint::cli {

/// Warnings about physical values that are absurd beside the others, most often a number in
/// millimetres, milliseconds or tonnes where metres, seconds or kilograms are meant. Each names the
/// value, what is wrong with it and the likely unit. The values are computed all the same.
[[nodiscard]] std::vector<std::string> doubtful_values(Command command, const Settings& all);

}  // namespace stillpoint::cli
