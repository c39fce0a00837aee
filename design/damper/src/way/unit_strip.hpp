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

/// A half-cycle back: its radius and phi = f/p, with their slopes.
struct EdgeStart {
  double radius{0};
  double radius_by_a{0};
  double phi{0};
  double phi_by_a{1};
};

/// (39): `steps` half-cycles back from the start, then to V0.
[[nodiscard]] EdgeSpeed followed_back(const EdgeStart& start, int steps, double d);

/// Of an interval.
struct Ends {
  double low;
  double high;
};

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

}  // namespace stillpoint::design::unit
