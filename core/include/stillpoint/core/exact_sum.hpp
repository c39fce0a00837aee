// SPDX-License-Identifier: MIT
#pragma once

// A running sum that keeps what each addition rounds away: the times and phases of a forced run.
// For double it is the unevaluated sum of two numbers, good to about 1e-32 of the largest term; a
// multiprecision scalar is its own exact sum.

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

  void add(const Real& term) {
    if constexpr (std::is_floating_point_v<Real>) {
      const Real sum = high_ + term;
      const Real taken = sum - high_;
      const Real lost = (high_ - (sum - taken)) + (term - taken);
      const Real rest = low_ + lost;
      high_ = sum + rest;
      low_ = rest - (high_ - sum);
    } else {
      high_ += term;
    }
  }

  void add_product(const Real& a, const Real& b) {
    const Real rounded = a * b;
    add(rounded);
    if constexpr (std::is_floating_point_v<Real>) {
      add(std::fma(a, b, -rounded));
    }
  }

  /// This less `other`, rounded once.
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
