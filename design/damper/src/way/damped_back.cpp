// SPDX-License-Identifier: MIT
// Half-cycles with damping, backwards: docs/damping.md section 6.
//
//   phi   f/p                        turn  of the mass, from the centre of its force: X + phi
//   s, w  speeds at x = 0            grown exp(2 zeta T), T the time of that quarter of a cycle
#include "way/unit_strip.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stillpoint::design::unit {

namespace {

double omega_of(double zeta) {
  return std::sqrt((1 - zeta) * (1 + zeta));
}

/// A value with its slopes by a and d.
struct Sloped {
  double value{0};
  double by_a{0};
  double by_d{0};
};

struct Backwards {
  double zeta;
  double omega;
  double phi;
  double phi_by_a;

  /// R(s)^2 of (D15).
  [[nodiscard]] double radius_square(double square) const {
    return phi * phi + 2 * zeta * phi * std::sqrt(square) + square;
  }
  /// Its slope by phi, where T has one too.
  [[nodiscard]] double by_phi(double square) const {
    return 2 * phi + 4 * zeta * std::sqrt(square);
  }

  /// The square of the speed that leaves x = 0 for a turn: the root of G(s)^2 = turn^2, which is
  /// concave in s^2, so that Newton's method comes up from the root without damping.
  [[nodiscard]] Sloped left_for(const Sloped& turn) const {
    constexpr int most = 50;
    constexpr double short_step = 1e-9;  // the last one: each doubles the correct digits
    double square = std::max(0.0, (turn.value - phi) * (turn.value + phi));
    double grown = 1;
    for (int i = 0; i < most; ++i) {
      const double s = std::sqrt(square);
      grown = elementary::exp(2 * zeta / omega * elementary::atan2(omega * s, phi + zeta * s));
      const double step = turn.value * turn.value * grown - radius_square(square);
      square = std::max(0.0, square + step);
      if (step <= short_step * square) {
        break;
      }
    }
    const double by_turn = 2 * turn.value * grown;
    return {square, by_turn * turn.by_a - by_phi(square) * phi_by_a, by_turn * turn.by_d};
  }

  /// The turn before an arrival with the speed of that square.
  [[nodiscard]] Sloped turn_before(const Sloped& arrival) const {
    const double w = std::sqrt(arrival.value);
    const double grown = elementary::exp(
        2 * zeta / omega * (std::numbers::pi - elementary::atan2(omega * w, phi + zeta * w)));
    const double turn = std::sqrt(radius_square(arrival.value) * grown);
    const double half = turn > 0 ? grown / (2 * turn) : 0;
    return {2 * phi + turn, 2 * phi_by_a + half * (by_phi(arrival.value) * phi_by_a + arrival.by_a),
            half * arrival.by_d};
  }
};

}  // namespace

EdgeSpeed damped_back(const EdgeStart& start, int steps, double d) {
  const Backwards back{start.zeta, omega_of(start.zeta), start.phi, start.phi_by_a};
  Sloped left = back.left_for({start.radius, start.radius_by_a, 0});
  for (int i = 0; i < steps; ++i) {
    left = back.left_for(back.turn_before({left.value + 2 * d, left.by_a, left.by_d + 2}));
  }
  return {left.value, left.by_a, left.by_d};
}

double shrinks_by(double zeta) {
  return elementary::exp(std::numbers::pi * zeta / omega_of(zeta));
}

double damped_acceleration(double zeta, double a) {
  const double omega = omega_of(zeta);
  const double felt = a + 2 * zeta;
  const double slope = 1 - 2 * zeta * felt;
  if (!(slope > 0)) {
    return felt;
  }
  const double until = elementary::atan2(omega * slope, felt + zeta * slope) / omega;
  return std::sqrt(felt * felt + 2 * zeta * felt * slope + slope * slope) *
         elementary::exp(-zeta * until);
}

}  // namespace stillpoint::design::unit
