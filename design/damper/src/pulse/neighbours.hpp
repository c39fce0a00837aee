// SPDX-License-Identifier: MIT
#pragma once

// What two motions with neighbouring f, a below b, say of those between them: docs/theory.md
// section 8.

#include "pulse/edge.hpp"
#include "pulse/first_return.hpp"

#include <stillpoint/design/problem.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// In the order of f.
inline void insert(std::vector<FirstReturn>& motions, const std::vector<FirstReturn>& more) {
  motions.insert(motions.end(), more.begin(), more.end());
  std::ranges::sort(motions, {}, &FirstReturn::f);
}

/// The square of the arrival speed where the mass arrives after at most so many turns; negative
/// where it does not, by what it is short of.
[[nodiscard]] double clearance_of(const FirstReturn& motion, double turns);

/// A quantity and its slope over f.
struct Rated {
  double value;
  double slope;
};

/// What a box asks for.
[[nodiscard]] Rated need_of(const FirstReturn& motion, Criterion criterion);
/// Of need/f^2: section 15.
[[nodiscard]] Rated need_over_square(const FirstReturn& motion, Criterion criterion);

/// A value and its position.
struct Placed {
  double at;
  double value;
};

/// The top of the parabola through three values, if it is between them. It may be wrong by
/// `unsure_top` of what they differ by.
[[nodiscard]] std::optional<Placed> top_of(const Placed& before, const Placed& now,
                                           const Placed& after);
inline constexpr double unsure_top = 0.1;

/// The slope of the cubic with these ends, over the part x of the step between them:
/// start + 2 linear x + square x^2.
struct CubicSlope {
  double start;
  double linear;
  double square;
};
[[nodiscard]] CubicSlope slope_of_cubic(const Rated& a, const Rated& b, double step);

/// The cubic with these ends rises beyond both of them, or falls and rises between.
[[nodiscard]] bool top_of_cubic(const Rated& a, const Rated& b, double step);

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
    // Where they do not cross between the two, the figure is not concave and they bound nothing.
    const bool bound = 0 <= tangents && tangents <= width;
    if ((bound && rises.value + rises.slope * tangents <= most + close * std::abs(most)) ||
        width <= 2 * edge_width(low.f, high.f)) {
      break;
    }
    const auto [start, linear, square] = slope_of_cubic(rises, falls, width);
    const double cubic = width * (start / (std::sqrt(linear * linear - square * start) - linear));
    const double least = edge_width(low.f, high.f);
    const FirstReturn now =
        at(low.f + std::clamp(step % 3 < 2 ? cubic : tangents, least, width - least));
    (figure(now).slope > 0 ? low : high) = now;
  }
  return figure(low).value > figure(high).value ? low : high;
}

/// Adds those of which the neighbours on both sides are `wanted`.
template <class At, class Figure, class Wanted>
void add_maxima(std::vector<FirstReturn>& points, const At& at, const Figure& figure,
                const Wanted& wanted) {
  std::vector<FirstReturn> found;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const FirstReturn& a = points[i - 1];
    const FirstReturn& b = points[i];
    if (wanted(a, b) && figure(a).slope > 0 && figure(b).slope < 0) {
      found.push_back(maximum(a, b, at, figure));
    }
  }
  insert(points, found);
}

/// The need neither jumps nor turns unseen between the two: their slopes explain what it changes by
/// to 1e-4 of the largest need of all; to 5 % of the change as well where they are of one kind, of
/// which the smaller need counts where it falls to nothing. There the speeds may explain it
/// instead.
[[nodiscard]] bool is_smooth(const FirstReturn& a, const FirstReturn& b, double largest);

/// Of two kinds, Newton's step from the one with fewer turns finds w = 0 before the other one, or
/// halves have not helped.
[[nodiscard]] bool may_jump(const FirstReturn& a, const FirstReturn& b, int depth);

}  // namespace stillpoint::design
