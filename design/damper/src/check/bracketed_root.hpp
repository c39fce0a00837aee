// SPDX-License-Identifier: MIT
#pragma once

// The events of the integrators that check a design, within one step.

#include <boost/math/tools/toms748_solve.hpp>

#include <cstdint>

namespace stillpoint::design {

/// Where the function changes its sign; the end at which it is 0, or `from` if it does not.
template <class Function>
double bracketed_root(const Function& function, double from, double to) {
  const double at_from = function(from);
  const double at_to = function(to);
  if (at_from == 0 || (at_from > 0) == (at_to > 0)) {
    return at_to == 0 ? to : from;
  }
  std::uintmax_t most_evaluations = 200;
  return boost::math::tools::toms748_solve(function, from, to, at_from, at_to,
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .first;
}

}  // namespace stillpoint::design
