// SPDX-License-Identifier: MIT
#pragma once

#include "way/unit_strip.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

namespace stillpoint::design {

struct Highest {
  double at;
  double value;
};

/// The steps of `highest`, in log f.
template <class F>
class HighestSearch {
 public:
  HighestSearch(const F& function, Interval f, double enough)
      : function_(function), f_(f), enough_(enough) {}

  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double f_at(double at) const {
    return std::clamp(elementary::exp(at), f_.low, f_.high);
  }
  [[nodiscard]] Highest found() const { return {f_at(best_.at), best_.value}; }

  /// True if it is enough.
  bool consider(double at) { return consider(at, value_at(at)); }

  /// Tries some values from above, where the designs with some constant friction are. Empty if one
  /// is enough, else the neighbours of the best.
  std::optional<Interval> scan() {
    const auto places = scanned();
    for (const double at : places) {
      if (consider(at)) {
        return std::nullopt;
      }
    }
    Interval around{low_, high_};
    for (const double at : places) {
      if (at > best_.at) {
        around.high = at;
      } else if (at < best_.at) {
        around.low = at;
        break;
      }
    }
    return around;
  }

  /// By golden sections.
  void narrow(const Interval& around) {
    constexpr double golden = std::numbers::phi - 1;
    constexpr double resolved = 1e-9;
    auto [left, right] = around;
    double inner_left = right - golden * (right - left);
    double inner_right = left + golden * (right - left);
    double at_left = value_at(inner_left);
    double at_right = value_at(inner_right);
    while (right - left > resolved) {
      if (at_left > at_right ? consider(inner_left, at_left) : consider(inner_right, at_right)) {
        return;
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
  }

 private:
  [[nodiscard]] double value_at(double at) const { return function_(f_at(at)); }

  bool consider(double at, double value) {
    if (value > best_.value) {
      best_ = {at, value};
    }
    return best_.value >= enough_;
  }

  /// From above.
  [[nodiscard]] auto scanned() const {
    constexpr int across = 8;    // evenly over f
    constexpr int decades = 16;  // evenly over log f
    std::array<double, across + decades> places{};
    for (int i = 0; i < decades; ++i) {
      places[static_cast<std::size_t>(i)] = low_ + (high_ - low_) * i / decades;
    }
    for (int i = 0; i < across; ++i) {
      const double part = (i + 0.5) / across;
      places[static_cast<std::size_t>(decades + i)] =
          elementary::log(f_.low + (f_.high - f_.low) * part);
    }
    std::ranges::sort(places, std::greater());
    return places;
  }

  const F& function_;
  Interval f_;
  double enough_;
  double low_{elementary::log(f_.low)};
  double high_{elementary::log(f_.high)};
  Highest best_{high_, -HUGE_VAL};
};

/// The largest value of a function of log f that first rises and then falls, or the first that is
/// `enough`. It stops at once if `nowhere` says that no value between two f is positive.
template <class F, class Nowhere>
Highest highest(const F& function, Interval f, double enough, const Nowhere& nowhere) {
  HighestSearch search(function, f, enough);
  if (search.consider(search.high())) {
    return search.found();
  }
  const double middle = std::midpoint(f.low, f.high);
  if (nowhere(f.low, middle) && nowhere(middle, f.high)) {
    return search.found();
  }
  const auto around = search.scan();
  if (around && !nowhere(search.f_at(around->low), search.f_at(around->high))) {
    search.narrow(*around);
  }
  return search.found();
}

}  // namespace stillpoint::design
