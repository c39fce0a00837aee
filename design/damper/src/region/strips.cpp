// SPDX-License-Identifier: MIT
#include <stillpoint/design/strips.hpp>

#include "region/edges.hpp"
#include "way/extent.hpp"
#include "way/room.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

std::optional<Interval> delta_range(const Problem& problem, std::int64_t arrival, double f) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  const bool plain = is_plain(problem, {});
  if (plain && arrival == 1) {
    return f <= edges(problem, {}).f3 ? std::optional(Interval{unchecked_delta1(problem, f),
                                                               largest_delta_of_start(problem.v0)})
                                      : std::nullopt;
  }
  Problem any = problem;
  if (plain) {
    any.beta = 2 * problem.v0 / problem.p;  // f2 < 0
  }
  return feasible_delta(any, {}, arrival, f);
}

std::optional<Interval> feasible_delta(const Problem& problem, const Limits& limits,
                                       std::int64_t arrival, double f) {
  require_valid(problem, limits);
  require_within("f", f, 0, largest_square);
  const Way way = way_with(problem, limits, static_cast<int>(arrival), f);
  const auto range = centre_range(way, f, limits.tolerance);
  const double square = way.square();
  return range ? std::optional(Interval{range->low * square, range->high * square}) : std::nullopt;
}

double largest_stopping_f(const Problem& problem) {
  require_valid(problem);
  return largest_f(problem);
}

bool dead_zone_binds(const Problem& problem) {
  const double f1 = edges(problem, {}).f1;
  return largest_stopping_f(problem) >= std::nextafter(f1, 0.0);
}

double least_stopping_delta(const Problem& problem, double f) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  const Way last(problem, {}, static_cast<int>(problem.arrivals));
  return d_of_last_stop(last, last.scaled(f)) * last.square();
}

std::vector<Interval> merged(std::vector<Interval> all) {
  std::ranges::sort(all, {}, &Interval::low);
  std::vector<Interval> apart;
  for (const Interval& now : all) {
    if (!apart.empty() && now.low <= apart.back().high) {
      apart.back().high = std::max(apart.back().high, now.high);
    } else {
      apart.push_back(now);
    }
  }
  return apart;
}

std::vector<Interval> feasible_f(const std::vector<Strip>& strips) {
  std::vector<Interval> all;
  for (const Strip& strip : strips) {
    if (strip.f_lower) {
      all.push_back({*strip.f_lower, *strip.f_upper});
    }
  }
  return merged(std::move(all));
}

std::vector<Strip> strips(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  Limits any = limits;
  any.tolerance = 0;
  std::vector<Strip> list;
  for_each_way(problem, any, [&](const Way& way) {
    if (const double largest = most_tolerant(way).tolerance; largest > 0) {
      const auto ends = feasible_f(Way(problem, limits, way.n, way.at_peak));
      list.push_back({way.n, least_beta(way), ends ? std::optional(ends->low) : std::nullopt,
                      ends ? std::optional(ends->high) : std::nullopt, largest, way.at_peak});
    }
    return true;
  });
  return list;
}

}  // namespace stillpoint::design
