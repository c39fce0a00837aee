// SPDX-License-Identifier: MIT
#pragma once

// What the tests of this room use.

#include "random_source.hpp"
#include "reference.hpp"
#include "task.hpp"

#include <stillpoint/core.hpp>

namespace stillpoint::design_test {

using namespace stillpoint;
using namespace design;
using test::check_contains;
using test::check_refused;
using test::refusal_of;
using test::refused_field;

/// What the objective makes least, of a motion after a hit or under a pulse.
template <class Motion>
double value_of(Objective objective, const Motion& motion) {
  return objective == Objective::amplitude ? motion.peak_amplitude
         : objective == Objective::time    ? motion.stop_time.value_or(0)
                                           : motion.peak_absolute_acceleration;
}

}  // namespace stillpoint::design_test
