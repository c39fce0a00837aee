// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite_space.hpp"

#include <cstddef>
#include <vector>

namespace stillpoint::design {

/// Places in the box of a tolerance, from -1 to 1 along each axis that has one, 0 along the others:
/// first the corners, the middles between them and the design itself, then as many as are missing
/// from `count`, every other one of them on the boundary. With one axis they are even. The design
/// alone if nothing can be off.
[[nodiscard]] std::vector<SuitePlace> box_samples(const SuiteSpace& space, std::size_t count);

}  // namespace stillpoint::design
