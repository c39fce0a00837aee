// SPDX-License-Identifier: MIT
#include <stillpoint/design/tolerance.hpp>

#include "way/extent.hpp"
#include "way/room.hpp"
#include "way/way.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/strips.hpp>

#include <algorithm>

namespace stillpoint::design {

namespace {

/// Calls `visit` with each way that the point may take until it returns false. A point of one hit
/// and one spring takes that of its arrival, or none. Without constant friction the strips touch,
/// and a box may lie in several.
template <class Visit>
void for_each_way_of(const Problem& problem, const Limits& limits, double f, double delta,
                     const Visit& visit) {
  require_valid(problem, limits);
  require_within("f", f, 0, largest_square);
  require_within("delta", delta, 0, largest_square);
  const bool plain = is_plain(problem, limits);
  if (plain && problem.arrivals == 1) {
    visit(Way(problem, limits, 1));
  } else if (f == 0) {
    visit(Way(problem, limits, 0));
  } else if (!plain) {
    for_each_way(problem, limits, visit);
  } else if (const auto arrival = arrival_of(problem, f, delta)) {
    visit(Way(problem, limits, static_cast<int>(*arrival)));
  }
}

}  // namespace

bool admissible(const Problem& problem, const Limits& limits, double f, double delta) {
  bool found = false;
  for_each_way_of(problem, limits, f, delta, [&](const Way& way) {
    found = admissible(way, f, delta);
    return !found;
  });
  return found;
}

std::optional<double> largest_tolerance(const Problem& problem, const Limits& limits, double f,
                                        double delta) {
  std::optional<double> largest;
  for_each_way_of(problem, limits, f, delta, [&](const Way& way) {
    largest = std::max(largest, largest_tolerance(way, f, delta));  // empty is the least
    return true;
  });
  return largest;
}

std::optional<double> any_f_up_to(const Problem& problem, Limits limits, double delta,
                                  double tolerance) {
  constexpr double almost_all = 1 - 1e-9;  // of f: a box reaches down to nearly no friction
  limits.tolerance = almost_all;
  limits.shape = {1, 1, tolerance / almost_all, tolerance / almost_all};
  const auto works = [&](double largest) {
    return admissible(problem, limits, largest / (1 + almost_all), delta);
  };
  constexpr double close = 1e-6;
  const double top = largest_f(problem);
  double found = 0;
  for (double step = top / 2; step > close * top; step /= 2) {
    found += works(found + step) ? step : 0;
  }
  return found > 0 ? std::optional(found) : std::nullopt;
}

std::optional<DesignPoint> most_tolerant(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  if (!(limits.tolerance > 0)) {
    return std::nullopt;
  }
  const DesignPoint best = most_tolerant_of_all(problem, limits, 0);
  return best.tolerance > 0 && best.tolerance < limits.tolerance ? std::optional(best)
                                                                 : std::nullopt;
}

}  // namespace stillpoint::design
