// SPDX-License-Identifier: MIT
#include "step.hpp"
#include "step_results.hpp"

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search.hpp>

namespace stillpoint::sweep {

namespace {
using Eigen::Index;
using enum Quantity;
}  // namespace

void SweepStep::run_design(SweepBlock& block) const {
  make_room(block, {feasible, f, delta, tolerance, peak_amplitude, stop_time});
  const FreeOptions options{.times = times_, .margin = false};
  for_each(block, [&](Index i) {
    const design::Problem problem{
        .v0 = block[v0][i], .p = block[p][i], .beta = block[beta][i], .criterion = spec_.criterion};
    const auto found = design::search(problem, spec_.limits, spec_.search);
    block[feasible][i] = found ? 1 : 0;
    block[f][i] = found ? found->point.f : absent;
    block[delta][i] = found ? found->point.delta : absent;
    block[tolerance][i] = found ? found->point.tolerance : absent;
    block[peak_amplitude][i] = absent;
    block[stop_time][i] = absent;
    if (found) {
      const Response motion =
          free_response({.p = problem.p, .f = found->point.f, .delta = found->point.delta},
                        {.x0 = 0, .v0 = problem.v0}, options);
      block[peak_amplitude][i] = motion.peak_amplitude;
      block[stop_time][i] = motion.stop_time.value_or(absent);
    }
  });
}

}  // namespace stillpoint::sweep
