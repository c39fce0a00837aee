// SPDX-License-Identifier: MIT
#pragma once

// The ways to come to rest admissibly: docs/theory.md sections 7, 12 and 13.
//
//   way n >= 1  the n-th arrival at x = 0, or a rest within the residual beside its strip
//   way 0       breakaway f <= residual p^2: every rest is within the residual; with more friction
//   `at_peak`:
//               so is the first peak, where the mass stays
//
// In units of the strongest hit and the softest spring, as in unit_problem.hpp. The paper's task is
// way 1 of one hit, one spring and no residual.

#include "region/edges.hpp"
#include "way/unit_strip.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/design/problem.hpp>

#include <optional>

namespace stillpoint::design {

struct Way {
  Way(const Problem& what, const Limits& allowed, int arrival, bool by_peak = false);

  Problem problem;
  Limits limits;
  int n;
  bool at_peak;      ///< of way 0
  bool plain;        ///< as problem.hpp has it
  double f2;         ///< for `at_peak`, of the residual
  double f_cap;      ///< of the limits, and of the rests for way 0
  double tip;        ///< where the weakest hit only grazes x = 0; infinite for way 0
  double f_top;      ///< the smaller of the two
  double delta_cap;  ///< of the limits and of the start
  double v_low;      ///< the weakest hit that must come back, over V0; 0: all that move
  double p_ratio;    ///< of the stiffest spring to the softest
  double q;          ///< p r / V0
  double a2;
  double a_cap;  ///< of f_top
  double d_cap;

  [[nodiscard]] double scaled(double f) const { return f / problem.p / problem.v0; }
  [[nodiscard]] double f_of(double a) const { return a * problem.v0 * problem.p; }
  [[nodiscard]] double square() const { return problem.v0 * problem.v0; }
  [[nodiscard]] int passages() const { return static_cast<int>(problem.arrivals); }
  /// A second edge of stopping, beside that of the last arrival that is allowed.
  [[nodiscard]] bool stops_early() const { return n > 0 && n < passages(); }
  /// That of the last arrival binds.
  [[nodiscard]] bool stops_last() const { return !stops_early() || q > 0; }
  /// The paper's task itself, whose edges are closed forms.
  [[nodiscard]] bool is_papers_task() const { return plain && n == 1; }
  /// The first return to x = 0, whose conditions are the paper's own, each at its corner.
  [[nodiscard]] bool is_papers() const {
    return n == 1 && (plain || (!problem.residual && v_low > 0));
  }
  /// Every hit that moves comes back if Delta is large enough, (57).
  [[nodiscard]] bool returns_by_delta() const { return n == 1 && v_low == 0; }
  /// Delta changes whether the weakest hit comes back.
  [[nodiscard]] bool delta_hinders_return() const { return n > 1 && v_low > 0; }
};

/// How far a design stays inside its edges, relative: far above rounding, so that no edge depends
/// on the last digits, and far below manufacturing accuracy.
inline constexpr double way_inset = 1e-9;

/// The box of a tolerance, its sides as parts of its centre.
struct Sides {
  double f_low;
  double f_high;
  double delta_low;
  double delta_high;
};
[[nodiscard]] Sides sides(const BoxShape& shape, double tolerance);

/// The radii from which the edges are followed back: docs/theory.md (46), (55).
[[nodiscard]] unit::EdgeStart reach_start(const Way& way, double a);
[[nodiscard]] unit::EdgeStart last_start(const Way& way, double a);
[[nodiscard]] unit::EdgeStart stop_start(const Way& way, double a);

/// The edges of a way at a corner of the box, each a square of V0 with its slopes. `reach` is at
/// most v_low^2 where the weakest hit reaches the n-th arrival or rests within r before it; the
/// others are above 1 where the strongest one does not pass the last arrival allowed, or the n-th.
[[nodiscard]] unit::EdgeSpeed reach_edge(const Way& way, double a, double d);
[[nodiscard]] unit::EdgeSpeed last_edge(const Way& way, double a, double d);
[[nodiscard]] unit::EdgeSpeed stop_edge(const Way& way, double a, double d);
/// Twice the least Delta with which every hit that moves comes back, where v_low = 0: (57).
[[nodiscard]] unit::EdgeSpeed returning_notch(const Way& way, double a);

/// Every point of the box around (f, delta) takes this way: decided in pairs of doubles, right
/// to the last bit. The tolerance is that of the limits, or another.
[[nodiscard]] bool admissible(const Way& way, double f, double delta, double tolerance);
[[nodiscard]] bool admissible(const Way& way, double f, double delta);

/// The values of V0 of (46) at the corners of the ranges, exact to the last bit: what the rows of
/// the constraints show.
struct WaySpeeds {
  double reach;  ///< of V0, or of Delta if the way `returns_by_delta`
  double pass;
};
[[nodiscard]] WaySpeeds way_speeds(const Way& way, double f, double delta);

/// The task of only the motion shown, by the model itself.
[[nodiscard]] Problem strongest_hit(Problem problem);

/// The arrival that decides about a damper: that at which it stops the mass, or else the first one
/// that the mass does not reach, or the last one allowed if it passes all.
struct DecidingArrival {
  int n;
  bool stops;
};
[[nodiscard]] DecidingArrival deciding_arrival(const Problem& problem, double f, double delta);

/// breakaway f <= r p^2, and below f1, where the dead zone begins to be wider than beta; up to f1
/// if with all that friction the first peak is within r.
[[nodiscard]] double largest_f_at_rest(const Problem& problem);
/// The largest f of any way, whatever beta and the limits are.
[[nodiscard]] double largest_f(const Problem& problem);
/// The least beta of any damper of the way, whatever the limits are.
[[nodiscard]] double least_beta(const Way& way);
/// A rest beyond beta does not count, whatever residual is allowed.
[[nodiscard]] double residual_of(const Problem& problem);
/// phi at the start of the stop edge: 1 or, by the published criterion, 0.
[[nodiscard]] double stop_radius(const Problem& problem);

/// The way that a point takes, at the tolerance of the limits; empty if it takes none.
[[nodiscard]] std::optional<Way> way_of(const Problem& problem, const Limits& limits, double f,
                                        double delta);

/// That of an arrival and an f; 0 is of either kind.
[[nodiscard]] Way way_with(const Problem& problem, const Limits& limits, int arrival, double f);

/// Calls `visit` with each way that may have a box of the limits' tolerance, that of the first
/// arrival first and way 0 last, until it returns false.
template <class Visit>
void for_each_way(const Problem& problem, const Limits& limits, const Visit& visit) {
  constexpr double rounding = 1e-12;  // of a tolerance of 1 / (2n - 1)
  if (needs_a_notch(problem, limits)) {
    return;
  }
  const auto last = problem.v0_low == 0.0 ? 1 : static_cast<int>(problem.arrivals);
  for (int n = 1; n <= last; ++n) {
    cancellation_point();
    const Way way(problem, limits, n);
    // The tip of a later strip is at a smaller f, and its tolerance smaller: (49), (51).
    if (way.a_cap < way.a2 || way.a_cap <= 0 ||
        (way.q > 0 && way.a_cap * problem.breakaway < way.q && n > 1) ||
        (way.plain && limits.tolerance * (2 * n - 1) > 1 + rounding)) {
      break;
    }
    if (!visit(way)) {
      return;
    }
  }
  if (problem.residual.value_or(0) > 0 && visit(Way(problem, limits, 0))) {
    const Way at_peak(problem, limits, 0, true);
    if (at_peak.f2 > largest_f_at_rest(problem) && at_peak.f2 <= at_peak.f_cap) {
      visit(at_peak);
    }
  }
}

}  // namespace stillpoint::design
