// SPDX-License-Identifier: MIT
// A sweep: a million dampers at once, and what share of them stops the mass at x = 0.

#include <stillpoint/core.hpp>

#include <iostream>

int main() {
  constexpr Eigen::Index rows = 1000;
  // Every f from 0.001 to 0.35 with every delta from 0 to 0.5.
  const Eigen::ArrayXd one_f = Eigen::ArrayXd::LinSpaced(rows, 0.001, 0.35);
  const Eigen::ArrayXd one_delta = Eigen::ArrayXd::LinSpaced(rows, 0, 0.5);
  const Eigen::ArrayXd f = one_f.replicate(rows, 1);
  const Eigen::ArrayXd delta = one_delta.transpose().replicate(rows, 1).reshaped();

  const stillpoint::BatchResult motions = stillpoint::free_batch(1, 1, f, delta, {.times = true});

  const auto at_zero = motions.outcome == stillpoint::Outcome::stopped_at_zero;
  const auto at_once = at_zero && motions.half_cycles == 1;
  Eigen::Index soonest = 0;
  at_once.select(motions.stop_time, 1e300).minCoeff(&soonest);
  std::cout << motions.size() << " motions\n"
            << at_zero.count() << " stop at x = 0\n"
            << at_once.count() << " of them on the first return\n"
            << "soonest: f = " << f[soonest] << ", delta = " << delta[soonest] << ", after "
            << motions.stop_time[soonest] << '\n';
}
