// SPDX-License-Identifier: MIT
#pragma once

#include "golden_sections.hpp"
#include "way/unit_strip.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>

namespace stillpoint::design {

struct Highest {
  double at;
  double value;
};

/// The logarithms of some f from above, where the designs with some constant friction are: evenly
/// over f and over log f.
inline auto places_of(const Interval& f, const Interval& logs) {
  constexpr int across = 8;
  constexpr int decades = 16;
  std::array<double, across + decades> places{};
  for (int i = 0; i < decades; ++i) {
    places[static_cast<std::size_t>(i)] = logs.low + (logs.high - logs.low) * i / decades;
  }
  for (int i = 0; i < across; ++i) {
    const double part = (i + 0.5) / across;
    places[static_cast<std::size_t>(decades + i)] =
        elementary::log(f.low + (f.high - f.low) * part);
  }
  std::ranges::sort(places, std::greater());
  return places;
}

/// The largest value of a function of log f that first rises and then falls, or the first that is
/// `enough`. It stops at once if `nowhere` says that no value between two f is positive.
template <class F, class Nowhere>
Highest highest(const F& function, Interval f, double enough, const Nowhere& nowhere) {
  const Interval logs{elementary::log(f.low), elementary::log(f.high)};
  const auto f_at = [&](double at) { return std::clamp(elementary::exp(at), f.low, f.high); };
  const auto value_at = [&](double at) { return function(f_at(at)); };
  Highest best{logs.high, -HUGE_VAL};  // at its logarithm
  const auto is_enough = [&](double at, double value) {
    best = value > best.value ? Highest{at, value} : best;
    return best.value >= enough;
  };
  const auto found = [&] { return Highest{f_at(best.at), best.value}; };
  const double middle = std::midpoint(f.low, f.high);
  if (is_enough(logs.high, value_at(logs.high)) ||
      (nowhere(f.low, middle) && nowhere(middle, f.high))) {
    return found();
  }
  const auto places = places_of(f, logs);
  if (std::ranges::any_of(places, [&](double at) { return is_enough(at, value_at(at)); })) {
    return found();
  }
  const auto* const below = std::ranges::upper_bound(places, best.at, std::greater());
  const auto* const above = std::ranges::lower_bound(places, best.at, std::greater());
  const Interval around{below == places.end() ? logs.low : *below,
                        above == places.begin() ? logs.high : *std::prev(above)};
  if (nowhere(f_at(around.low), f_at(around.high))) {
    return found();
  }
  constexpr double a_little = 1e-7;
  const bool at_low = best.at == logs.low;
  const double inside = at_low ? logs.low + a_little : logs.high - a_little;
  if ((at_low || best.at == logs.high) && !(value_at(inside) > best.value)) {
    return found();  // an end from which it falls is the highest
  }
  constexpr double resolution = 1e-9;
  golden_sections(around, value_at, [&](const Interval& span, double at, double value) {
    return !(span.high - span.low > resolution) || is_enough(at, value);
  });
  return found();
}

template <class F>
Highest highest(const F& function, Interval f) {
  return highest(function, f, HUGE_VAL, [](double, double) { return false; });
}

}  // namespace stillpoint::design
