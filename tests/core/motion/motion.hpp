// SPDX-License-Identifier: MIT
#pragma once

// What the tests of this room use.

#include "testing/checks.hpp"
#include "testing/forced_scene.hpp"
#include "testing/near_tie.hpp"
#include "testing/scene_count.hpp"
#include "testing/scene_s5.hpp"
#include "testing/simple_forced.hpp"
#include "testing/simulation_of.hpp"
#include "testing/test.hpp"

#include <stillpoint/core.hpp>

namespace stillpoint::test {

using std::numbers::pi;

}  // namespace stillpoint::test
