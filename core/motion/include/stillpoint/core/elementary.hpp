// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

/// Elementary functions with the same bits on every machine.
///
/// The C library's differ in the last digit: from one library to the next, and in glibc between
/// processors with and without a fused multiply-add. These use only +, -, *, / and sqrt.
/// Errors, in units in the last place of the result: sine and cosine 0.8, atan2 0.51, asin and acos
/// 2, exp 0.501, log 0.6, between 0.501, hypot 1, pow about 100 at the ends of double's range
/// (tests/core/motion/elementary_test.cpp). NaN and the infinities behave as in the C library.
namespace stillpoint::elementary {

struct SinCos {
  double sine;
  double cosine;
};

/// Of an angle in radians. |x| > 1e6 is left to the C library: a motion reduces its phases before
/// they grow so large.
[[nodiscard]] SinCos sin_cos(double x);

/// The angle of (x, y) in radians, in [-pi, pi].
[[nodiscard]] double atan2(double y, double x);

/// In radians, of x in [-1, 1].
[[nodiscard]] double asin(double x);
[[nodiscard]] double acos(double x);

[[nodiscard]] double exp(double x);
[[nodiscard]] double log(double x);
/// x^y for x > 0, as exp(y log x): for grids, not for results.
[[nodiscard]] double pow(double x, double y);
/// low^(1 - t) high^t for low, high > 0 and t = part / of, which is more accurate than by pow.
[[nodiscard]] double between(double low, double high, double part, double of);
[[nodiscard]] double hypot(double x, double y);

}  // namespace stillpoint::elementary
