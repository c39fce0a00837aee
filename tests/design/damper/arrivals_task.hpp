// SPDX-License-Identifier: MIT
#pragma once

// Random tasks of several arrivals, docs/theory.md section 12.

#include "random_source.hpp"
#include "task.hpp"

#include <stillpoint/design.hpp>

#include <cmath>

namespace stillpoint::design_test::of_arrivals {

using namespace stillpoint::design;
using Wide = long double;

inline bool within_limits(const Problem& problem, const Limits& limits, Wide f, Wide delta) {
  const Wide p_v0 = Wide(problem.p) * problem.v0;
  return (!limits.f_max || f <= *limits.f_max) &&
         (!limits.delta_max || delta <= *limits.delta_max) &&
         (!limits.acceleration_max || std::sqrt(f * f + p_v0 * p_v0) <= *limits.acceleration_max);
}

inline Task random_task(RandomSource& random) {
  Task task{random_problem(random, 0.75, 1.5), {}, random.seed()};
  task.problem.arrivals = 2 + random.pick(4);
  const double f3 = task.problem.v0 * task.problem.p / std::sqrt(8.0);
  random.one_in(2, task.limits.f_max, [&] { return f3 * random.log_uniform(0.01, 1.1); });
  random.one_in(3, task.limits.delta_max,
                [&] { return task.problem.v0 * task.problem.v0 * random.uniform(0.05, 0.5); });
  random.one_in(4, task.limits.acceleration_max, [&] {
    return task.problem.p * task.problem.v0 * std::sqrt(1 + random.uniform(0, 0.1));
  });
  task.limits.tolerance = random.pick(2) == 0 ? 0 : random.uniform(0.01, 0.3);
  return task;
}

}  // namespace stillpoint::design_test::of_arrivals
