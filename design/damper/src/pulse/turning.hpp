// SPDX-License-Identifier: MIT
#pragma once

#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

/// Where the slope of a cubic with these ends, which rises at the one and falls at the other,
/// vanishes: the part of the step.
inline double top_between(const Rated& rises, const Rated& falls, double step) {
  const double chord = (falls.value - rises.value) / step;
  const double linear = 3 * chord - 2 * rises.slope - falls.slope;
  const double square = 3 * (rises.slope + falls.slope - 2 * chord);
  return rises.slope / (std::sqrt(linear * linear - square * rises.slope) - linear);
}

/// The motion where a figure is largest between one where it rises and one where it falls: by the
/// cubic through both where it is smooth, and by the crossing of the tangents, which finds a kink.
/// `at` gives the motion of an f, `figure` its value and slope.
template <class At, class Figure>
FirstReturn maximum(FirstReturn low, FirstReturn high, const At& at, const Figure& figure) {
  constexpr double close = 1e-10;  // of the value, by the tangents
  constexpr int most_motions = 60;
  for (int step = 0; step < most_motions; ++step) {
    const Rated rises = figure(low);
    const Rated falls = figure(high);
    const double width = high.f - low.f;
    const double tangents =
        (falls.value - rises.value - falls.slope * width) / (rises.slope - falls.slope);
    const double most = std::max(rises.value, falls.value);
    if (rises.value + rises.slope * tangents <= most + close * std::abs(most) ||
        width <= 2 * edge_width(low.f, high.f)) {
      break;
    }
    const double cubic = width * top_between(rises, falls, width);
    const double least = edge_width(low.f, high.f);
    const FirstReturn now =
        at(low.f + std::clamp(step % 3 < 2 ? cubic : tangents, least, width - least));
    (figure(now).slope > 0 ? low : high) = now;
  }
  return figure(low).value > figure(high).value ? low : high;
}

}  // namespace stillpoint::design
