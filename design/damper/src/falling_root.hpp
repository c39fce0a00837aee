// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>

namespace stillpoint::design {

/// The zero of a decreasing function.
template <class F>
double falling_root(const F& function, double low, double high, double at_low, double at_high) {
  std::uintmax_t most_evaluations = 100;
  return boost::math::tools::toms748_solve(function, low, high, at_low, at_high,
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .first;
}

}  // namespace stillpoint::design
