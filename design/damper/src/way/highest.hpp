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

  void narrow(const Interval& around) {
    constexpr double resolution = 1e-9;
    constexpr double a_little = 1e-7;
    if (best_.at == low_ || best_.at == high_) {  // an end from which it falls is the highest
      const double inside = best_.at == low_ ? low_ + a_little : high_ - a_little;
      if (!(value_at(inside) > best_.value)) {
        return;
      }
    }
    golden_sections(
        around, [this](double at) { return value_at(at); },
        [this](const Interval& span, double at, double value) {
          return !(span.high - span.low > resolution) || consider(at, value);
        });
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
