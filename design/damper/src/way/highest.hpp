// SPDX-License-Identifier: MIT
#pragma once

#include "way/unit_strip.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>

namespace stillpoint::design {

struct Highest {
  double at;
  double value;
};

/// The largest value of a function of log f that first rises and then falls, or the first that is
/// `enough`. It stops at once where `nowhere` says of two f that no value between them is positive.
template <class F, class Nowhere>
Highest highest(const F& function, unit::Ends f, double enough, const Nowhere& nowhere) {
  constexpr int across = 8;    // evenly over f
  constexpr int decades = 16;  // evenly over log f
  const double from = elementary::log(f.low);
  const double to = elementary::log(f.high);
  Highest best{to, -HUGE_VAL};
  const auto f_at = [&](double at) { return std::clamp(elementary::exp(at), f.low, f.high); };
  const auto value_at = [&](double at) { return function(f_at(at)); };
  const auto consider = [&](double at) {
    const double value = value_at(at);
    if (value > best.value) {
      best = {at, value};
    }
    return best.value >= enough;
  };
  const auto found = [&] { return Highest{f_at(best.at), best.value}; };
  if (consider(to)) {
    return found();
  }
  const double middle = std::midpoint(f.low, f.high);
  if (nowhere(f.low, middle) && nowhere(middle, f.high)) {
    return found();
  }
  std::array<double, across + decades> tried{};
  for (int i = 0; i < decades; ++i) {
    tried[static_cast<std::size_t>(i)] = from + (to - from) * i / decades;
  }
  for (int i = 0; i < across; ++i) {
    const double part = (i + 0.5) / across;
    tried[static_cast<std::size_t>(decades + i)] = elementary::log(f.low + (f.high - f.low) * part);
  }
  // From above: there are the designs that have some constant friction.
  std::ranges::sort(tried, std::greater());
  for (const double at : tried) {
    if (consider(at)) {
      return found();
    }
  }
  double left = from;
  double right = to;
  for (const double at : tried) {
    if (at > best.at) {
      right = at;
    } else if (at < best.at) {
      left = at;
      break;
    }
  }
  if (nowhere(f_at(left), f_at(right))) {
    return found();
  }
  constexpr double golden = 0.6180339887498949;
  constexpr double resolved = 1e-9;
  double inner_left = right - golden * (right - left);
  double inner_right = left + golden * (right - left);
  double at_left = value_at(inner_left);
  double at_right = value_at(inner_right);
  while (right - left > resolved) {
    if (std::max(at_left, at_right) > best.value) {
      best = at_left > at_right ? Highest{inner_left, at_left} : Highest{inner_right, at_right};
      if (best.value >= enough) {
        break;
      }
    }
    if (at_left >= at_right) {
      right = inner_right;
      inner_right = inner_left;
      at_right = at_left;
      inner_left = right - golden * (right - left);
      at_left = value_at(inner_left);
    } else {
      left = inner_left;
      inner_left = inner_right;
      at_left = at_right;
      inner_right = left + golden * (right - left);
      at_right = value_at(inner_right);
    }
  }
  return found();
}

}  // namespace stillpoint::design
