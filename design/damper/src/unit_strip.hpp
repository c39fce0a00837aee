// SPDX-License-Identifier: MIT
#pragma once

// The strip of the n-th arrival, n >= 2, with one parameter left: docs/theory.md section 12, in the
// units of unit_problem.hpp.

#include <stillpoint/design/problem.hpp>

#include <optional>

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

[[nodiscard]] EdgeSpeed reach_edge(int n, double a, double d);                      ///< (46)
[[nodiscard]] EdgeSpeed stop_edge(Criterion criterion, int n, double a, double d);  ///< (46)

struct Ends {
  double low;
  double high;
};

/// The largest a of the exact strip, (49), where d = 0.
[[nodiscard]] double strip_tip(int n);

/// The a (1 + R) of all boxes of half-width R in the strip that keep d (1 + R) <= d_cap. The lower
/// end is 0 if it is open towards f = 0. Empty if there is no such box.
[[nodiscard]] std::optional<Ends> high_corners(Criterion criterion, int n, double tolerance,
                                               double d_cap);

/// The d of the centres of those boxes for one a of the centre.
[[nodiscard]] std::optional<Ends> centre_range(Criterion criterion, int n, double tolerance,
                                               double d_cap, double a);

/// The largest R for which both corners of a box around (a, d) are in the strip; 0 where the centre
/// is not.
[[nodiscard]] double strip_tolerance(Criterion criterion, int n, double a, double d);

/// The motion up to its n-th arrival.
struct Course {
  double phase{0};  ///< p T, (52)
  double by_a{0};   ///< its slopes, cut as that of stop_phase
  double by_d{0};
  double arrival_speed{0};  ///< of the n-th arrival, over V0
  double grazing{0};        ///< (53): the error of the phase over that of the energies
};

/// A half-cycle that does not come back counts as one that only just does. `error` is the absolute
/// one of (w / V0)^2 that (53) asks about.
[[nodiscard]] Course course(int n, double a, double d, double error = 1e-16);

}  // namespace stillpoint::design::unit
