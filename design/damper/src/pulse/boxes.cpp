// SPDX-License-Identifier: MIT
// The boxes of a tolerance in the region of a pulse: those that fit an interval of f, and the
// widest around a point. docs/theory.md section 8.

#include "pulse/edge.hpp"
#include "pulse/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace stillpoint::design {

double PulseRegion::most_tolerance() const {
  return std::max(widest_tolerance, asked_);
}

double PulseRegion::use_of_delta(double low, double high, double tolerance,
                                 KnownMotions& known) const {
  return std::isinf(delta_max_)
             ? 0
             : known.need_between(low, high, criterion_) * use_per_need(tolerance);
}

std::vector<Island> PulseRegion::parts(const Island& island, double tolerance, double use,
                                       KnownMotions& known) const {
  if (std::isinf(delta_max_)) {
    return {island};
  }
  const double most = use / use_per_need(tolerance) * (1 - edge_rounding);
  const auto at = [&](double f) { return known.at(f); };
  const auto need = [&](const FirstReturn& now) { return now.need(criterion_); };
  const auto left = [&](const FirstReturn& now) { return most - need(now); };
  std::vector<FirstReturn> points = known.between(island.low, island.high);
  if (std::ranges::all_of(points, [&](const FirstReturn& now) { return left(now) >= 0; })) {
    return {island};
  }
  // It may be enough between two f where it is not.
  if (profile_->is_single()) {
    add_maxima(
        points, at,
        [&](const FirstReturn& now) {
          return Rated{left(now), -now.slope(criterion_)};
        },
        [&](const FirstReturn& a, const FirstReturn& b) { return left(a) < 0 && left(b) < 0; });
  } else {
    add_minima(points, at, need, most);
  }
  return where(points, at, left);
}

bool PulseRegion::feasible() const {
  KnownMotions known(*profile_);
  return std::ranges::any_of(islands_, [&](const Island& island) {
    return std::ranges::any_of(parts(island, asked_, 1, known),
                               [&](const Island& part) { return spare(part, asked_) >= 0; });
  });
}

std::optional<Island> PulseRegion::around_boxes() const {
  constexpr double beside = 1e-9;
  KnownMotions known(*profile_);
  std::optional<Island> around;
  for (const Island& island : islands_) {
    for (const auto& [low, high] : parts(island, asked_, 1, known)) {
      if (spare({low, high}, asked_) >= -beside) {
        around = around ? Island{around->low, high} : Island{low, high};
      }
    }
  }
  return around ? std::optional(Island{around->low * (1 - beside), around->high * (1 + beside)})
                : std::nullopt;
}

bool PulseRegion::reaches_down_to_0(const Island& island) const {
  return island.low <= profile_->samples().front().f * (1 + edge_rounding);
}

double PulseRegion::widest_by_edges(const Island& island, double f) const {
  // A side of the box that does not move allows any tolerance.
  const auto along = [](double room, double side) { return side > 0 ? room / side : HUGE_VAL; };
  const double low = reaches_down_to_0(island) ? 0 : island.low;
  return f < island.low || f > island.high
             ? 0
             : std::min({most_tolerance(), along((f - low) / f, shape_.f_low),
                         along((island.high - f) / f, shape_.f_high)});
}

double PulseRegion::widest(const Island& island, double f, double delta,
                           KnownMotions& known) const {
  const auto room = [&](double tolerance) {
    const double low = std::max(reaches_down_to_0(island) ? 0 : island.low, low_of(f, tolerance));
    const double high = std::min(island.high, high_of(f, tolerance));
    if (std::isinf(delta)) {
      return 1 - use_of_delta(low, high, tolerance, known);
    }
    return std::min(
        delta_max_ - delta * (1 + shape_.delta_high * tolerance),
        delta * (1 - shape_.delta_low * tolerance) - known.need_between(low, high, criterion_));
  };
  const double by_edges = widest_by_edges(island, f);
  if (room(by_edges) >= 0) {
    return by_edges;
  }
  return room(0) >= 0 ? last_not_negative(0.0, by_edges, room) : 0;
}

DesignPoint PulseRegion::with_best_delta(const Island& island, double f,
                                         KnownMotions& known) const {
  constexpr double reserve = 0.5;
  const double inside = std::clamp(f, island.low, island.high);
  const double tolerance = widest(island, inside, HUGE_VAL, known);
  const double need =
      known.need_between(std::max(island.low, low_of(inside, tolerance)),
                         std::min(island.high, high_of(inside, tolerance)), criterion_);
  // An arrival at rest needs a notch as well, of any size.
  const double least =
      std::max(need, std::numeric_limits<double>::epsilon() * known.at(inside).peak);
  const double delta =
      std::min(least / (1 - std::max(shape_.delta_low * tolerance, reserve)) * (1 + edge_rounding),
               delta_max_ / (1 + shape_.delta_high * tolerance));
  return {inside, delta, tolerance};
}

std::optional<double> PulseRegion::tolerance_of(double f, double delta) const {
  for (const Island& island : islands_) {
    if (island.low <= f && f <= island.high && delta <= delta_max_ &&
        at(f).need(criterion_) <= delta) {
      KnownMotions known(*profile_);
      return widest(island, f, delta, known);
    }
  }
  // Below every sample nothing but the need changes.
  const auto fits = [&](double tolerance) {
    const double high = high_of(f, tolerance);
    const FirstReturn worst = profile_->between(low_of(f, tolerance), high);
    return holds(worst) && high <= f_max_ &&
           delta * (1 + shape_.delta_high * tolerance) <= delta_max_ &&
           worst.need(criterion_) <= delta * (1 - shape_.delta_low * tolerance);
  };
  if (!(f < profile_->samples().front().f && fits(0))) {
    return std::nullopt;
  }
  const double most = most_tolerance();
  return fits(most) ? most : last_that_holds(0.0, most, fits);
}

std::optional<double> least_delta(const PulseProblem& problem, double f) {
  return least_delta(problem)(f);
}

std::function<std::optional<double>(double)> least_delta(const PulseProblem& problem) {
  const auto worst = problem.has_ranges() ? std::make_shared<const WorstReturn>(problem) : nullptr;
  return [problem, worst](double f) -> std::optional<double> {
    const double k = peak_load(problem.pulse);
    const FirstReturn motion =
        worst ? worst->at(f / k) : first_return(problem.pulse, problem.p, f / k);
    return motion.returns
               ? std::optional(motion.need(problem.criterion) * (k / problem.p) * (k / problem.p))
               : std::nullopt;
  };
}

std::function<std::optional<Interval>(double)> feasible_delta(const PulseProblem& problem,
                                                              const Limits& limits) {
  require_valid(problem, limits);
  const auto region = std::make_shared<const PulseRegion>(problem, limits);
  return [region](double f) -> std::optional<Interval> {
    const double tolerance = region->asked();
    const double low = region->low_of(f / region->f_unit(), tolerance);
    const double high = region->high_of(f / region->f_unit(), tolerance);
    KnownMotions known(*region->profile());
    const bool inside = std::ranges::any_of(region->islands(), [&](const Island& island) {
      return (island.low <= low || region->reaches_down_to_0(island)) && high <= island.high;
    });
    if (!inside || !known.at(low).returns) {
      return std::nullopt;
    }
    const Interval delta{known.need_between(low, high, region->criterion()) /
                             (1 - region->shape().delta_low * tolerance),
                         region->delta_max() / (1 + region->shape().delta_high * tolerance)};
    const double unit = region->delta_unit();
    return delta.low <= delta.high ? std::optional(Interval{delta.low * unit, delta.high * unit})
                                   : std::nullopt;
  };
}

}  // namespace stillpoint::design
