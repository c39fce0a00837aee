// SPDX-License-Identifier: MIT
#pragma once

// The intervals of f in which a requirement holds, from motions at some f: the edges are roots
// between neighbours.

#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"
#include "pulse/neighbours.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stillpoint::design {

/// Of f, in units of k.
using Island = Interval;

/// More than the rounding of a motion in other units, and less than any manufacturing accuracy.
inline constexpr double edge_rounding = 1e-13;

/// Where `room` is >= 0, a little inside of the edges. `at` gives the motion of an f.
template <class At, class Room>
std::vector<Island> where(const std::vector<FirstReturn>& points, const At& at, const Room& room) {
  const auto edge = [&](double inside, double outside) {
    return last_not_negative(inside, outside, [&](double f) { return room(at(f)); });
  };
  std::vector<Island> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (room(points[i]) < 0) {
      continue;
    }
    const double low = i == 0 ? points[i].f : edge(points[i].f, points[i - 1].f);
    while (i + 1 < points.size() && room(points[i + 1]) >= 0) {
      ++i;
    }
    const double high = i + 1 == points.size() ? points[i].f : edge(points[i].f, points[i + 1].f);
    if (low * (1 + edge_rounding) <= high * (1 - edge_rounding)) {
      found.push_back({low * (1 + edge_rounding), high * (1 - edge_rounding)});
    }
  }
  return found;
}

/// A figure may be within its limit between two points where it is not.
template <class At, class Figure>
void add_minima(std::vector<FirstReturn>& points, const At& at, const Figure& figure,
                double limit) {
  constexpr int bits = 24;
  constexpr double known = 0x1p-20;
  std::vector<FirstReturn> found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FirstReturn& before = points[i == 0 ? 0 : i - 1];
    const FirstReturn& after = points[std::min(i + 1, points.size() - 1)];
    const double now = figure(points[i]);
    if (now > limit && now <= figure(before) && now <= figure(after) &&
        after.f - before.f > known * after.f) {
      const auto value = [&](double f) { return figure(at(f)); };
      found.push_back(
          at(boost::math::tools::brent_find_minima(value, before.f, after.f, bits).first));
    }
  }
  insert(points, found);
}

}  // namespace stillpoint::design
