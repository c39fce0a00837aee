// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

namespace stillpoint {

/// The oscillator of the paper's (6), dimensionless, with viscous damping:
///   x'' + 2 zeta p x' + (f + delta * dirac(x)) sgn x' + p^2 x = -W.
///
/// `delta` acts only at x = 0: each passage costs the kinetic energy v^2/2 = delta. `f` and
/// `delta` are the paper's f and Delta, both >= 0; `p`^2 is its stiffness p^2, p > 0.
///
/// In the paper a mass at rest in the notch stays there under any load, and `hold` is empty. A
/// notch with a hold >= 0 lets the mass go when |W| exceeds f + hold: docs/notches.md. The
/// difference shows only under a load, and with delta > 0.
///
/// Beyond the paper (docs/damping.md): `zeta` is the share of critical damping, and friction holds
/// a mass at rest up to `breakaway` times f.
template <class Real>
struct BasicOscillator {
  Real p{1};
  Real f{0};
  Real delta{0};
  std::optional<Real> hold{};
  Real zeta{0};
  Real breakaway{1};

  /// Slides and rests by f alone, as in the paper.
  [[nodiscard]] bool coulomb() const { return zeta == 0 && breakaway == 1; }
};
using Oscillator = BasicOscillator<double>;

/// Where a motion starts at tau = 0. The paper starts at x0 = 0.
template <class Real>
struct BasicStart {
  Real x0{0};
  Real v0{0};
};
using Start = BasicStart<double>;

/// Speeds v0, p * |x0| and f / p are 0 or within these bounds, so that the kernel squares them and
/// multiplies two of them without overflow and without a loss that matters.
inline constexpr double largest_speed = 1e150;
inline constexpr double smallest_speed = 1e-150;
/// f / p may be smaller, since it is added to larger speeds.
inline constexpr double smallest_friction_speed = 1e-307;
/// p times the smallest peak, v0^2 p / f where friction dominates: anything less would underflow.
inline constexpr double smallest_peak_speed = 1e-300;
/// The largest delta and |x0|; the first is compared with squares of speeds.
inline constexpr double largest_square = 1e300;
/// The largest damping: beyond it the mass returns with less than 1e-10 of its speed, which
/// rounding may turn into another return.
inline constexpr double largest_zeta = 0.99;
/// The largest static over sliding friction.
inline constexpr double largest_breakaway = 1e6;

/// Whether the notch holds a start at x = 0 with v0 != 0: v0^2 < 2 delta, rule 4 of docs/theory.md.
/// The exact square decides, not the rounded one.
template <class Real>
[[nodiscard]] bool holds_at_start(const Real& delta, const Real& v0) {
  const Real square = v0 * v0;
  const Real notch = 2 * delta;
  if constexpr (std::is_floating_point_v<Real>) {
    if (square == notch) {
      const Real scale = std::abs(v0) < 1 ? 0x1p300 : 1;  // so that the error does not underflow
      return std::fma(v0 * scale, v0 * scale, -notch * scale * scale) < 0;
    }
  }
  return square < notch;
}

/// Throws InputError, naming `field`, unless f, a friction or the load that a notch holds, is 0 or
/// f / p in [1e-307, 1e150].
void require_friction(const std::string& field, double f, double p);

/// Throws InputError, naming the field, unless
///   p in [1e-150, 1e150]; f is 0 or f / p in [1e-307, 1e150]; 0 <= delta <= 1e300; hold is
///   empty, 0, or hold / p in [1e-307, 1e150]; zeta in [0, 0.99]; breakaway in [1, 1e6].
void require_valid(const Oscillator& oscillator);

/// Throws InputError, naming the field, unless the oscillator is valid, v0 and p * x0 are 0 or have
/// a magnitude in [1e-150, 1e150], |x0| <= 1e300, and v0^2 p / f is 0 or at least 1e-300.
void require_valid(const Oscillator& oscillator, const Start& start);

}  // namespace stillpoint
