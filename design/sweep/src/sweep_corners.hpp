// SPDX-License-Identifier: MIT
#pragma once

#include "sweep_task.hpp"

#include <vector>

namespace stillpoint::cli {

/// Throws InputError, naming the field, where a corner of the grid is refused: what is wrong with a
/// grid mostly shows there, before hours of it are done.
void check_corners(const std::vector<SweepAxis>& axes, const SweepTask& task);

}  // namespace stillpoint::cli
