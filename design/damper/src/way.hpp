// SPDX-License-Identifier: MIT
#pragma once

// The ways to come to rest admissibly, for ranges of V0 and p, a residual and a box of any shape:
// docs/theory.md section 13.
//
//   way n >= 1  the n-th arrival at x = 0, or a rest within the residual beside its strip
//   way 0       f <= residual p^2: every rest is within the residual
//
// In units of the strongest hit and the softest spring, as in unit_problem.hpp.

#include "region_edges.hpp"
#include "unit_strip.hpp"

#include <stillpoint/design/problem.hpp>
#include <stillpoint/design/search.hpp>

#include <optional>

namespace stillpoint::design {

struct Way {
  Way(const Problem& what, const Limits& allowed, int arrival);

  Problem problem;
  Limits limits;
  int n;
  double f2;
  double f_cap;      ///< of the limits, and of the residual for way 0
  double delta_cap;  ///< of the limits and of the start
  double v_low;      ///< the weakest hit that must come back, over V0; 0: all that move
  double p_ratio;    ///< of the stiffest spring to the softest
  double q;          ///< p r / V0
  double a2;
  double f_top;  ///< the same and the strip's tip, where the weakest hit only grazes x = 0
  double a_cap;
  double d_cap;

  [[nodiscard]] double scaled(double f) const { return f / problem.p / problem.v0; }
  [[nodiscard]] double f_of(double a) const { return a * problem.v0 * problem.p; }
  [[nodiscard]] double square() const { return problem.v0 * problem.v0; }
  [[nodiscard]] int passages() const { return static_cast<int>(problem.arrivals); }
  [[nodiscard]] Way with_box(double tolerance) const;
  /// A second edge of stopping, beside that of the last arrival that is allowed.
  [[nodiscard]] bool stops_early() const { return n > 0 && n < passages(); }
};

/// The edges of a way at a corner of the box, each a square of V0 with its slopes. `reach` is at
/// most v_low^2 where the weakest hit reaches the n-th arrival or rests within r before it; the
/// others are above 1 where the strongest one does not pass the last arrival allowed, or the n-th.
[[nodiscard]] unit::EdgeSpeed reach_edge(const Way& way, double a, double d);
[[nodiscard]] unit::EdgeSpeed last_edge(const Way& way, double a, double d);
[[nodiscard]] unit::EdgeSpeed stop_edge(const Way& way, double a, double d);
/// Twice the least Delta with which every hit that moves comes back, where v_low = 0: (57).
[[nodiscard]] unit::EdgeSpeed returning_notch(const Way& way, double a);

/// Every point of the box of the limits around (f, delta) takes this way.
[[nodiscard]] bool admissible(const Way& way, double f, double delta);
/// The largest tolerance of the point; empty if it is not admissible itself.
[[nodiscard]] std::optional<double> largest_tolerance(const Way& way, double f, double delta);
/// The largest tolerance of any point of the way.
[[nodiscard]] double largest_tolerance(const Way& way);

/// The Delta of the centres of the boxes that fit for one f, over V0^2.
[[nodiscard]] std::optional<unit::Ends> centre_range(const Way& way, double f);
/// The f of the centres of all boxes that fit; a lower end of 0 is open.
[[nodiscard]] std::optional<unit::Ends> feasible_f(const Way& way);
/// A point whose box fits; empty if there is none.
struct WayPoint {
  double f;
  double delta;
};
[[nodiscard]] std::optional<WayPoint> any_point(const Way& way);

/// The Delta that goes best with an f: with the most tolerance, or the least or the largest one.
enum class BestDelta { middle, least, largest };
[[nodiscard]] DesignPoint with_best_delta(const Way& way, double f,
                                          BestDelta choice = BestDelta::middle);

/// The largest f of any way, whatever beta and the limits are.
[[nodiscard]] double largest_f(const Problem& problem);

/// The least beta of any damper of the way, whatever the limits are.
[[nodiscard]] double least_beta(const Way& way);

/// The values of V0 of (46) at the corners of the ranges, exact to the last bit: what the rows of
/// the constraints show.
struct WaySpeeds {
  double reach;  ///< of V0, or of Delta where v_low = 0
  double pass;
};
[[nodiscard]] WaySpeeds way_speeds(const Way& way, double f, double delta);

/// The way of a point, at the tolerance of the limits; empty where it takes none.
[[nodiscard]] std::optional<int> way_of(const Problem& problem, const Limits& limits, double f,
                                        double delta);

/// Calls `visit` with each way that may have a point, that of the first arrival first and way 0
/// last, until it returns false.
template <class Visit>
void for_each_way(const Problem& problem, const Limits& limits, const Visit& visit) {
  const auto last = problem.v0_low == 0.0 ? 1 : static_cast<int>(problem.arrivals);
  for (int n = 1; n <= last; ++n) {
    const Way way(problem, limits, n);
    // The tip of a later strip is at a smaller f.
    if (way.a_cap < way.a2 || way.a_cap <= 0 || (way.q > 0 && way.a_cap < way.q && n > 1)) {
      break;
    }
    if (!visit(way)) {
      return;
    }
  }
  if (problem.residual.value_or(0) > 0) {
    visit(Way(problem, limits, 0));
  }
}

}  // namespace stillpoint::design
