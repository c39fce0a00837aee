// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/interval.hpp>

#include <numbers>
#include <utility>

namespace stillpoint::design {

/// Where a function that first rises and then falls is largest, by golden sections of `span` until
/// `done(span, place, value)`, given the better of the two places that are known.
template <class Function, class Done>
double golden_sections(Interval span, const Function& function, const Done& done) {
  constexpr double golden = std::numbers::phi - 1;
  auto& [low, high] = span;
  double left = high - golden * (high - low);
  double right = low + golden * (high - low);
  double at_left = function(left);
  double at_right = function(right);
  while (left < right &&
         !(at_left > at_right ? done(span, left, at_left) : done(span, right, at_right))) {
    if (at_left < at_right) {
      low = std::exchange(left, right);
      at_left = at_right;
      right = low + golden * (high - low);
      at_right = function(right);
    } else {
      high = std::exchange(right, left);
      at_right = at_left;
      left = high - golden * (high - low);
      at_left = function(left);
    }
  }
  return at_left < at_right ? right : left;
}

}  // namespace stillpoint::design
