// SPDX-License-Identifier: MIT
#pragma once

// The formulas of the admissible region and of the designed motion as the paper writes them, in 50
// digits, where no form is badly conditioned. The tests compare the library with these.

#include "testing/exact.hpp"

#include <stillpoint/design/problem.hpp>

#include <boost/math/constants/constants.hpp>
#include <boost/test/unit_test.hpp>

namespace stillpoint::design_test {

using Precise = test::Exact;

/// What the paper calls S, Delta1, A_1 and so on, for one problem.
class Reference {
 public:
  explicit Reference(const design::Problem& problem)
      : v0_(problem.v0), p_(problem.p), beta_(problem.beta), criterion_(problem.criterion) {}

  [[nodiscard]] Precise f1() const { return beta_ * p_ * p_; }
  [[nodiscard]] Precise f2() const { return (v0_ * v0_ - beta_ * p_ * beta_ * p_) / (2 * beta_); }
  [[nodiscard]] Precise f3() const { return v0_ * p_ / sqrt(Precise(8)); }
  [[nodiscard]] Precise delta2() const { return v0_ * v0_ / 2; }
  [[nodiscard]] Precise beta_min() const { return v0_ / (sqrt(Precise(2)) * p_); }

  [[nodiscard]] Precise s(const Precise& f) const { return sqrt(f * f + v0_ * p_ * v0_ * p_); }
  [[nodiscard]] Precise delta1_published(const Precise& f) const {
    const Precise speed = 2 * f - s(f);
    return speed * speed / (2 * p_ * p_);
  }
  [[nodiscard]] Precise delta1_exact(const Precise& f) const {
    const Precise speed = 2 * f - s(f);
    return (speed * speed - f * f) / (2 * p_ * p_);
  }
  [[nodiscard]] Precise delta1(const Precise& f) const {
    return criterion_ == design::Criterion::published ? delta1_published(f) : delta1_exact(f);
  }

  [[nodiscard]] Precise peak(const Precise& f) const { return (s(f) - f) / (p_ * p_); }
  [[nodiscard]] Precise arrival_speed(const Precise& f) const {
    const Precise square = 2 * delta1_exact(f);
    return square > 0 ? Precise(sqrt(square)) : Precise(0);
  }
  /// Up to the peak, then down from it.
  [[nodiscard]] Precise stop_time(const Precise& f) const {
    const Precise cosine = -f / (s(f) - 2 * f);
    const Precise down =
        cosine > -1 ? Precise(acos(cosine)) : boost::math::constants::pi<Precise>();
    return (atan2(Precise(v0_ * p_), f) + down) / p_;
  }

 private:
  Precise v0_;
  Precise p_;
  Precise beta_;
  design::Criterion criterion_;
};

/// |value - expected| <= bound; prints both numbers if not.
inline boost::test_tools::predicate_result within(double value, const Precise& expected,
                                                  const Precise& bound) {
  const Precise error = abs(Precise(value) - expected);
  boost::test_tools::predicate_result result(error <= bound);
  if (!result) {
    result.message() << value << " instead of " << expected.str(20) << ": off by " << error.str(3)
                     << ", allowed are " << bound.str(3);
  }
  return result;
}

/// The same, relative to the expected value.
inline boost::test_tools::predicate_result close(double value, const Precise& expected,
                                                 double tolerance) {
  return within(value, expected, Precise(abs(expected) * tolerance));
}

}  // namespace stillpoint::design_test
