// SPDX-License-Identifier: MIT
#pragma once

// The motion to the n-th arrival and the edges of its strip: docs/theory.md section 12, in the
// units of unit_problem.hpp.

namespace stillpoint::design::unit {

/// The square of the V0 of an edge, which a strip compares with 1, and its slopes. It grows with a
/// and d.
struct EdgeSpeed {
  double square{0};
  double by_a{0};
  double by_d{0};
};

/// A half-cycle back: its radius and phi = f/p, with their slopes. The mass turns at radius - phi.
struct EdgeStart {
  double radius{0};
  double radius_by_a{0};
  double phi{0};
  double phi_by_a{1};
  double zeta{0};
};

/// (39), with damping (D21): `steps` half-cycles back from the start, then to V0.
[[nodiscard]] EdgeSpeed followed_back(const EdgeStart& start, int steps, double d);
[[nodiscard]] EdgeSpeed damped_back(const EdgeStart& start, int steps, double d);  ///< zeta > 0

/// exp(pi zeta / omega): by that much a turn is farther from the centre of its force than the next.
[[nodiscard]] double shrinks_by(double zeta);
/// The largest that the structure feels of a hit, over V0 p, docs/damping.md section 4.
[[nodiscard]] double damped_acceleration(double zeta, double a);

/// The motion up to its n-th arrival.
struct Course {
  double phase{0};  ///< p T, (52)
  double by_a{0};   ///< its slopes, cut as that of stop_phase
  double by_d{0};
  double arrival_speed{0};  ///< of the n-th arrival, over V0
  double grazing{0};        ///< (53): the error of the phase over that of the energies
};

/// A half-cycle that does not come back counts as one that only just does. `error` is the absolute
/// error of (w / V0)^2 in (53).
[[nodiscard]] Course course(int n, double a, double d, double error = 1e-16);

/// The whole motion of a hit, wherever it comes to rest: docs/theory.md sections 3 and 5. Not taken
/// from the kernel.
struct Rest {
  double phase{0};  ///< p T
  int half_cycles{0};
  double position{0};       ///< p x / V0; 0 where it stops at x = 0
  double arrival_speed{0};  ///< of the last arrival, over V0; 0 without one
  double grazing{0};        ///< the error of phase and position over that of the energies, as (53)
};

/// Followed for at most that many half-cycles. `error` is the absolute one of (w / V0)^2.
[[nodiscard]] Rest rest(double a, double d, int most, double error = 1e-16);

}  // namespace stillpoint::design::unit
