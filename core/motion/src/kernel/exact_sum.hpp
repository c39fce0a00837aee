// SPDX-License-Identifier: MIT
#pragma once

// A running sum that keeps the rounding error of each addition: the times and phases of a forced
// run. For double it is the unevaluated sum of two numbers, good to about 1e-32 of the largest
// term; a multiprecision scalar is its own exact sum.

#include <stillpoint/core/double_pair.hpp>

#include <cmath>
#include <type_traits>
#include <utility>

namespace stillpoint {

template <class Real>
class ExactSum {
 public:
  ExactSum() = default;
  explicit ExactSum(Real value) : high_(std::move(value)) {}

  [[nodiscard]] static ExactSum product(const Real& a, const Real& b) {
    ExactSum sum;
    sum.add_product(a, b);
    return sum;
  }

  [[nodiscard]] const Real& high() const { return high_; }
  [[nodiscard]] const Real& low() const { return low_; }
  [[nodiscard]] Real value() const { return high_ + low_; }

  void add(const Real& term) { add(term, Real(0)); }

  /// `rest` is small compared with the term.
  void add(const Real& term, const Real& rest) {
    if constexpr (std::is_floating_point_v<Real>) {
      const auto [sum, lost] = two_sum(high_, term);
      const Real low = low_ + (lost + rest);
      high_ = sum + low;
      low_ = (sum - high_) + low;  // low is an ulp or two of the terms: this rounding is negligible
    } else {
      high_ += term + rest;
    }
  }

  void add_product(const Real& a, const Real& b) { add_product(a, b, Real(0)); }

  /// Also a small `rest`.
  void add_product(const Real& a, const Real& b, const Real& rest) {
    const Real rounded = a * b;
    if constexpr (std::is_floating_point_v<Real>) {
      add(rounded, std::fma(a, b, -rounded) + rest);
    } else {
      add(rounded, rest);
    }
  }

  /// This minus `other`, rounded once.
  [[nodiscard]] Real minus(const ExactSum& other) const {
    ExactSum difference = *this;
    difference.add(-other.high_);
    difference.add(-other.low_);
    return difference.value();
  }

 private:
  Real high_{0};
  Real low_{0};
};

}  // namespace stillpoint
