// SPDX-License-Identifier: MIT
#include "pulse/edge.hpp"
#include "pulse/task.hpp"

#include <stillpoint/core/elementary.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stillpoint::design {

namespace {

/// The middle of the largest box that fits: boxes only get better as they shrink.
double middle_of_largest_box(const PulseTask& task) {
  const PulseRegion& region = task.region;
  const auto& [low, high] = task.part;
  const double sides = high * region.shape().f_low + low * region.shape().f_high;
  const double by_edges = sides > 0 ? (high - low) / sides : HUGE_VAL;
  constexpr double rounding = 1e-15;
  const double most = std::min(by_edges, region.most_tolerance()) * (1 - rounding);
  const auto parts = [&](double tolerance) {
    return region.parts(task.part, tolerance, task.most_use, task.known);
  };
  const auto room = [&](double tolerance) {
    double widest = -1;
    for (const Island& part : parts(tolerance)) {
      widest = std::max(widest, region.spare(part, tolerance));
    }
    return widest;
  };
  const double asked = region.asked();
  constexpr double close = 1e-13;
  const auto done = [](double fits, double too_large) { return too_large - fits <= close * fits; };
  const double tolerance = most <= asked     ? asked
                           : room(most) >= 0 ? most
                                             : last_not_negative(asked, most, room, done);
  // Of equal ones, the one with the largest f has the least peak and Delta.
  double middle = task.middles().high;
  constexpr double nothing = -1e-12;  // the edges of a part are known to rounding
  for (const Island& part : parts(tolerance)) {
    if (region.spare(part, tolerance) >= nothing) {
      middle = region.middles(part, tolerance).high;
    }
  }
  return middle;
}

/// The motions between two f that are known, and more where they are few.
std::vector<FirstReturn> looks_between(const PulseTask& task, double low, double high) {
  constexpr std::size_t enough = 8;
  std::vector<FirstReturn> looks = task.known.between(low, high);
  for (std::size_t i = 1; looks.size() < enough && i < enough && low < high; ++i) {
    looks.push_back(
        task.known.at(low * elementary::pow(high / low, static_cast<double>(i) / enough)));
  }
  std::ranges::sort(looks, {}, &FirstReturn::f);
  return looks;
}

}  // namespace

PulseBest bracketed(const PulseTask& task) {
  PulseBest best;
  if (task.objective == Objective::robust) {
    best.consider(task, middle_of_largest_box(task));
    return best;
  }
  const auto [low, high] = task.middles();
  const std::vector<FirstReturn> looks = looks_between(task, low, high);
  std::size_t at_best = 0;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const double least = best.cost;
    best.consider(task, looks[i].f);
    at_best = best.cost < least ? i : at_best;
  }
  const double left = looks[at_best == 0 ? 0 : at_best - 1].f;
  const double right = looks[std::min(at_best + 1, looks.size() - 1)].f;
  // At an end from which the cost grows there is nothing to refine.
  constexpr double aside = 1e-4;
  const double end = looks[at_best].f;
  const double inside = at_best == 0 ? end + aside * (right - end) : end - aside * (end - left);
  const bool interior = left < end && end < right;
  if (left < right && (interior || task.cost(inside) < task.cost(end))) {
    constexpr int bits = 24;
    best.consider(task, boost::math::tools::brent_find_minima(
                            [&](double f) { return task.cost(f); }, left, right, bits)
                            .first);
  }
  return best;
}

}  // namespace stillpoint::design
