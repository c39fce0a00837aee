// SPDX-License-Identifier: MIT

// The free half-cycle map with damping, docs/damping.md section 4, in units where p = 1: for a
// double and for lanes, with the same operations, so that both find the same bits.
//
// | here   | means                                                                            |
// |--------|----------------------------------------------------------------------------------|
// | phi    | f / p                                                                            |
// | speed  | v with which x = 0 is left or reached                                            |
// | radius | R, (D15)                                                                         |
// | level  | G: the peak + phi                                                                |
// | time   | from x = 0 to the peak, p tau                                                    |

// Read once for each instruction set, as Highway requires.
#if defined(STILLPOINT_DAMPED_SWING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STILLPOINT_DAMPED_SWING_INL
#undef STILLPOINT_DAMPED_SWING_INL
#else
#define STILLPOINT_DAMPED_SWING_INL
#endif

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace stillpoint::HWY_NAMESPACE {

HWY_INLINE double root(double x) {
  return std::sqrt(x);
}

/// a where left > right, otherwise b.
HWY_INLINE double where_more(double left, double right, double a, double b) {
  return left > right ? a : b;
}

/// (1 - atan(t)/t)/t^2 in z = t^2, by its values at 20 of Chebyshev's points of 0 <= z <= 1.
inline constexpr std::array<double, 20> arc_series{
    0x1.5555555555555p-2, -0x1.9999999999620p-3,  0x1.24924924753ecp-3,  -0x1.c71c71bb00a6cp-4,
    0x1.745d15ee35819p-4, -0x1.3b1399d1dcdc7p-4,  0x1.110fff599e4d2p-4,  -0x1.e1d0239d392a6p-5,
    0x1.aebbb1647a168p-5, -0x1.841dcf603a209p-5,  0x1.5d02278205cc7p-5,  -0x1.3328700bb8169p-5,
    0x1.00390504e9f2fp-5, -0x1.843f4bca23369p-6,  0x1.fd0e4de8fed90p-7,  -0x1.123baedb61abdp-7,
    0x1.ca3677db66678p-9, -0x1.1325b2f8964bep-10, 0x1.a359b96a4eee4p-13, -0x1.2f07811f9f6e9p-16};

/// (exp(-x) - 1 + x)/x^2, the same at 11 points.
inline constexpr std::array<double, 11> fall_series{
    0x1.fffffffffffffp-2,  -0x1.5555555555390p-3,  0x1.55555555439c8p-5,  -0x1.1111110cbc0a0p-7,
    0x1.6c16c055975edp-10, -0x1.a019d8be752e2p-13, 0x1.a0164117de6c2p-16, -0x1.71a55abd09f7dp-19,
    0x1.25b6d2ada09dcp-22, -0x1.9366e376387b6p-26, 0x1.79bebcb01bcbfp-30};

/// The first `count` terms; `powers` are x, x^2, x^4 and so on. Few terms wait for each other.
template <std::size_t count, class T, std::size_t size>
HWY_INLINE T polynomial(const double* factors, const std::array<T, size>& powers) {
  if constexpr (count == 1) {
    return factors[0];
  } else {
    constexpr std::size_t half = std::bit_floor(count - 1);
    return polynomial<half>(factors, powers) +
           powers[std::bit_width(half) - 1] * polynomial<count - half>(factors + half, powers);
  }
}

template <class T, std::size_t count>
HWY_INLINE T polynomial(const std::array<double, count>& factors, T x) {
  const T x2 = x * x;
  const T x4 = x2 * x2;
  const T x8 = x4 * x4;
  return polynomial<count>(factors.data(), std::array{x, x2, x4, x8, x8 * x8});
}

/// From x = 0 to the peak.
template <class T>
struct DampedReach {
  T square;  ///< of the radius
  T level;
  T excess;  ///< level^2 - phi^2, for a peak of less than phi, whose digits `level` has lost
  T time;
};

/// At x = 0, coming back.
template <class T>
struct DampedArrival {
  T energy;  ///< v^2
  T speed;
  T time;  ///< as of a reach with this speed
};

template <class T>
struct DampedSwing {
  T phi;
  T zeta;
  T decay;  ///< E: from one turn to the next

  /// (D15) and (D17), for speed > 0.
  [[nodiscard]] HWY_INLINE DampedReach<T> reach(T speed) const {
    const T axis = phi + zeta * speed;
    const T square = phi * phi + speed * (2 * zeta * phi + speed);
    const T radius = root(square);
    const T k = speed / (radius + axis);
    const T z = (1 - zeta) * (1 + zeta) * (k * k);
    const T late = k * (z * polynomial(arc_series, z));
    const T time = 2 * (k - late);
    const T x = zeta * time;
    const T bend = x * x * polynomial(fall_series, x);
    const T fall = bend - x;  // exp(-x) - 1
    const T excess = speed * speed * (1 - 2 * (zeta * zeta)) -
                     2 * (zeta * z) * (speed * (2 * radius + axis)) +
                     square * (2 * bend + fall * fall + 4 * (zeta * late));
    return {square, radius + radius * fall, excess, time};
  }

  [[nodiscard]] HWY_INLINE T peak(const DampedReach<T>& up) const {
    return where_more(up.level, 2 * phi, up.level - phi, up.excess / (up.level + phi));
  }

  /// (D16): the excursion on the other side, were there nothing at x = 0; < 0: it turns before.
  [[nodiscard]] HWY_INLINE T next(T peak) const { return decay * (peak - phi) - phi; }

  /// At x = 0 on the way to it.
  [[nodiscard]] HWY_INLINE DampedArrival<T> arrival(T excursion) const {
    const T near = near_speed(excursion);
    const DampedReach<T> at = reach(near);
    const T sum = at.level + phi;
    const T missing =
        where_more(at.level, 2 * phi, excursion - (at.level - phi), excursion * sum - at.excess);
    const T step = missing / where_more(at.level, 2 * phi, at.level, at.level * sum);
    const T r = phi / near;
    // (D19)
    const T rho = 1 + r * (2 * zeta + r);
    const T q = 4 + r * (4 * zeta + 3 * r);
    const T third =
        1 - step * (q * 0.25 - step * (((q + 1) * q + r * (4 * zeta + 6 * r) * rho) * 0.05));
    const T bent = (1 + 2 * (zeta * r)) - zeta * (r * r * r) * step * third * (2.0 / 3);
    const T gained = at.square * step * (2 + step * bent);
    const T energy = near * near + gained;
    const T speed = root(energy);
    const T both = speed + near;
    const T none = excursion * 0;
    const T turned = phi * gained / (both * (phi * (phi + zeta * both) + speed * near));
    const T y = where_more(phi, none, turned, none);  // without friction a slow one would be 0/0
    const T yy = (1 - zeta) * (1 + zeta) * (y * y);
    const T time = at.time + (y - y * yy * (1.0 / 3 - yy * (1.0 / 5)));
    return {where_more(excursion, none, energy, none), where_more(excursion, none, speed, none),
            where_more(excursion, none, time, none)};
  }

 private:
  /// To 0.4 %, and with little damping much nearer: (D18).
  [[nodiscard]] HWY_INLINE T near_speed(T excursion) const {
    const T half = root(excursion * phi);
    const T whole = (1.783 - 1.268 * zeta) * excursion;
    const T share =
        ((1.506 + 0.658 * zeta) * half + whole) / (phi + (1.406 + 0.296 * zeta) * half + whole);
    const T gain = 1 + zeta * (1.5786 + zeta * (0.1904 - 0.0506 * zeta));
    const T more = 2 * (gain * (gain - 2 * zeta) - 1);
    return root(excursion * (phi * (2 + more * share) + gain * gain * excursion));
  }
};

}  // namespace stillpoint::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
