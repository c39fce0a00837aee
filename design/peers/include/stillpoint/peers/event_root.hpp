// SPDX-License-Identifier: MIT
#pragma once

#include <boost/math/tools/roots.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace stillpoint::peers {

/// Where `function` changes its sign in [from, to], to the last bit; `to` if it does not. It may
/// vanish at `from`, where a piece begins at rest: that root does not count.
template <class Function>
double bracketed_root(const Function& function, double from, double to) {
  const double at_to = function(to);
  double low = from;
  double at_low = function(from);
  for (int halvings = 1; at_low == 0 && halvings < 40; ++halvings) {
    low = from + std::ldexp(to - from, -halvings);
    const double there = function(low);
    at_low = there * at_to < 0 ? there : 0;
  }
  if (!(at_low * at_to < 0)) {
    return to;
  }
  std::uintmax_t most_evaluations = 100;
  return boost::math::tools::toms748_solve(function, low, to, at_low, at_to,
                                           boost::math::tools::eps_tolerance<double>(),
                                           most_evaluations)
      .second;
}

/// The same by Newton's method kept within the bracket, for methods whose states within a step cost
/// as much as a step: `function` gives the value and its rate.
template <class Function>
double newton_root(const Function& function, double from, double to) {
  const auto [at_from, rate_from] = function(from);
  const auto [at_to, rate_to] = function(to);
  if (!(at_from * at_to < 0)) {
    return bracketed_root([&](double t) { return function(t).first; }, from, to);
  }
  std::uintmax_t most_evaluations = 50;
  const double chord = from - at_from * (to - from) / (at_to - at_from);
  // Half of the digits: Newton's last step doubles them.
  return boost::math::tools::newton_raphson_iterate(
      [&](double t) { return function(t); }, chord, from, to,
      std::numeric_limits<double>::digits / 2, most_evaluations);
}

}  // namespace stillpoint::peers
