// SPDX-License-Identifier: MIT
#include "search/best_point.hpp"

#include "way/room.hpp"
#include "way/space.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace stillpoint::design {

namespace {

/// The Delta to try with an f. The peak and the acceleration do not depend on it, nor does the time
/// of the first arrival; that of a later one grows with it; with a residual it may jump.
std::span<const BestDelta> choices(const Way& way, Objective objective) {
  static constexpr std::array any{BestDelta::most_tolerant, BestDelta::least, BestDelta::largest};
  const std::span all(any);
  return objective != Objective::time || way.is_papers_task() ? all.first(1)
         : way.plain                                          ? all.subspan(1, 1)
                                                              : all;
}

}  // namespace

void BestPoint::consider(double f) {
  if (!(f > 0)) {  // SLSQP returns NaN if its subproblem is degenerate
    return;
  }
  f = std::min(f, way_.f_top);
  constexpr double same = 1e-10;  // as far as NLopt resolves x
  if (cost_ < HUGE_VAL && (std::abs(f - point_.f) <= same * f || !may_be_better(f))) {
    return;
  }
  for (const BestDelta choice : choices(way_, objective_)) {
    consider(f, best_delta(way_, f, choice));
  }
}

void BestPoint::consider(double f, double delta) {
  const bool robust = objective_ == Objective::robust;
  if (cost_ == HUGE_VAL || may_be_better(f)) {
    consider({f, delta, robust ? largest_tolerance(way_, f, delta).value_or(0) : 0});
  }
}

void BestPoint::consider(const DesignPoint& candidate) {
  const auto& [f, delta, tolerance] = candidate;
  const double its = way_cost(way_, objective_, candidate);
  // The force is flat towards f = 0: of those that are equal, the least f.
  const bool less =
      its < cost_ || (objective_ == Objective::acceleration && its == cost_ && f < point_.f);
  if (less && admissible(way_, f, delta)) {
    point_ = candidate;
    cost_ = its;
  }
}

DesignPoint BestPoint::point() const {
  return objective_ == Objective::robust
             ? point_
             : DesignPoint{point_.f, point_.delta,
                           largest_tolerance(way_, point_.f, point_.delta).value_or(0)};
}

/// Compares largest tolerances without computing them: the room for Delta falls with the tolerance.
bool BestPoint::may_be_better(double f) const {
  return objective_ != Objective::robust ||
         (tolerance_of_f(way_, f) > -cost_ && room(way_, way_.scaled(f), -cost_) > 0);
}

}  // namespace stillpoint::design
