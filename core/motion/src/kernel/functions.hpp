// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/core/elementary.hpp>

#include <cmath>

/// The functions of elementary.hpp for the other scalars of the kernels, from their own libraries.
namespace stillpoint::elementary {

template <class Real>
struct SinCosOf {
  Real sine;
  Real cosine;
};

template <class Real>
[[nodiscard]] SinCosOf<Real> sin_cos(const Real& x) {
  using std::cos;
  using std::sin;
  return {sin(x), cos(x)};
}

template <class Real>
[[nodiscard]] Real atan2(const Real& y, const Real& x) {
  using std::atan2;
  return atan2(y, x);
}

template <class Real>
[[nodiscard]] Real asin(const Real& x) {
  using std::asin;
  return asin(x);
}

template <class Real>
[[nodiscard]] Real acos(const Real& x) {
  using std::acos;
  return acos(x);
}

template <class Real>
[[nodiscard]] Real exp(const Real& x) {
  using std::exp;
  return exp(x);
}

}  // namespace stillpoint::elementary

namespace stillpoint {

/// |value|, of any scalar.
template <class Real>
[[nodiscard]] Real magnitude(const Real& value) {
  using std::abs;
  return abs(value);
}

}  // namespace stillpoint
