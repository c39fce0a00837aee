// SPDX-License-Identifier: MIT
#pragma once

// How many passages of x = 0 a damped free motion certainly has: (D20) of docs/damping.md.

#include "kernel/damped_terms.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stillpoint {

/// After a turn at `turn` = p |x|. Without a passage it ends no farther out than `end`; within |u|
/// friction takes at most taken(u) of v^2 + u^2 on a half-cycle, the notch `notch`. 0 unless they
/// are more than `few`.
template <class Taken>
double certain_passages(double turn, double end, double notch, double zeta, double few,
                        const Taken& taken) {
  constexpr double most_zeta = 1e-3;  // with more they are at most 3e5, which are soon counted
  const double last = std::max(end * end, notch);
  double square = turn * turn;
  const auto least = [&](double u) {
    return std::max(notch + taken(u), std::numeric_limits<double>::min());
  };
  if (zeta > most_zeta || !(square > last) || (square - last) / least(std::sqrt(last)) <= few) {
    return 0;
  }
  const double fall = 2 * std::numbers::pi * zeta / swing_rate(zeta);  // -2 ln E
  const double share = fall * (1 - fall / 2);                          // less than 1 - E^2
  double passages = 0;
  while (square > last) {
    const double next = std::max(square / 2, last);
    const double lost = least(std::sqrt(square)) + share * next;
    const double x = share * (square - next) / lost;
    constexpr double small = 1e-4;  // below, ln(1 + x) would lose its digits
    const double log = x < small ? 1 - x / 2 : elementary::log(1 + x) / x;
    constexpr double rounded = 1 - 1e-6;  // what the rounding of a motion may change
    passages += std::max(rounded * (square - next) / lost * (1 - fall / 2) * log - 1, 0.0);
    square = next;
  }
  return std::min(passages, largest_square);
}

}  // namespace stillpoint
