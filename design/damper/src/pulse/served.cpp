// SPDX-License-Identifier: MIT
// The pulses and the springs that a damper works for, docs/theory.md (71), (72).
#include "pulse/served.hpp"

#include "pulse/edge.hpp"
#include "pulse/intervals.hpp"

#include <stillpoint/design/works_for.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace stillpoint::design {

namespace {

/// Of every limit: a need may be the same for many k, where rounding would decide whether a Delta
/// that is equal to it is enough. Less than edge_rounding, so that the ends stay within the limits.
constexpr double for_rounding = 1 + 1e-14;

/// As a part of both; 0 of nothing.
double room_of(double value, double limit) {
  return value == limit ? 0 : std::isinf(limit) ? 1 : (limit - value) / (limit + value);
}

double most(double limit, double value) {
  return value > 0 ? limit / value : HUGE_VAL;
}

/// With a motion of this f/k, which stands for every smaller one too.
double largest_k(const DamperRooms& damper, const FirstReturn& motion, double p) {
  double k =
      std::min(farthest_k(damper, motion, p), stopped_k(damper, motion, p, damper.criterion));
  for (std::size_t i = 0; i < figure_count; ++i) {
    k = std::min(k, most(damper.figures_max[i], motion.*limited_figures[i]->figure->under_pulse));
  }
  return k * (1 - edge_rounding);
}

/// In units of the strongest pulse and the softest spring.
FirstReturn worst_motion(const PulseProblem& problem, double unit_f) {
  return problem.has_ranges() ? WorstReturn::only_at(problem, unit_f)
                              : first_return(problem.pulse, problem.p, unit_f);
}

ServedInterval served_k(const PulseProblem& problem, const DamperRooms& damper) {
  const double strongest = peak_load(problem.pulse);
  const double weakest = problem.ranges.k_low.value_or(strongest);
  const WorstReturn motions = for_any_k(problem);
  const auto at = [&](double unit_f) { return motions.found_at(unit_f); };
  if (damper.f == 0) {
    return {0, std::max(strongest, largest_k(damper, at(0), problem.p))};
  }
  const auto room = [&](const FirstReturn& now) {
    return damper.room(now, damper.f / now.f, problem.p);
  };
  const double least = damper.f / strongest;
  const double most = damper.f / weakest;
  std::vector<FirstReturn> points = motions.samples();
  insert(points, {at(least), at(most)});
  ServedInterval served{weakest, strongest};
  for (const Island& now : where(points, at, room)) {
    constexpr double beside = 2 * edge_rounding;
    if (now.low > most * (1 + beside) || now.high < least * (1 - beside)) {
      continue;
    }
    served.low = std::min(served.low, damper.f / now.high);
    // The least f/k that is examined stands for all below it.
    const bool to_0 = now.low <= points.front().f * (1 + beside);
    const double stronger =
        to_0 ? largest_k(damper, points.front(), problem.p) : damper.f / now.low;
    served.high = std::max(*served.high, stronger);
  }
  return served;
}

/// From a p that is kept to the first edge on the way to `end`; `end` without one.
template <class Room>
double last_spring(double from, double end, double pulse_length, const Room& room) {
  // As the legs of (61).
  constexpr double part = 0.1;
  constexpr double turn = 0.3;
  constexpr int bits = 24;
  const auto edge = [&](double kept, double not_kept) {
    return last_not_negative(kept, not_kept, room);
  };
  struct Tried {
    double p;
    double room;
  };
  Tried before{from, HUGE_VAL};
  Tried now{from, room(from)};
  while (now.p != end && now.room >= 0) {
    const double step = 1 + std::min(part, turn / (pulse_length * now.p));
    const double p = end > from ? std::min(end, now.p * step) : std::max(end, now.p / step);
    const Tried next{p, room(p)};
    if (next.room < 0) {
      return edge(now.p, next.p);
    }
    if (now.room < before.room && now.room < next.room) {
      const auto [place, least] = boost::math::tools::brent_find_minima(
          room, std::min(before.p, next.p), std::max(before.p, next.p), bits);
      if (least < 0) {
        return edge(before.p, place);
      }
    }
    before = now;
    now = next;
  }
  return now.p;
}

ServedInterval served_p(const PulseProblem& problem, const DamperRooms& damper) {
  const double k = peak_load(problem.pulse);
  const double stiffest = problem.p_high.value_or(problem.p);
  const auto room = [&](double p) {
    PulseProblem one = problem;
    one.p = p;
    one.p_high = {};
    return damper.room(worst_motion(one, damper.f / k), k, p);
  };
  const auto [least, most] = searched_p(problem);
  const double length = *duration(excitation(problem.pulse));
  ServedInterval served{last_spring(problem.p, least, length, room),
                        last_spring(stiffest, most, length, room)};
  if (served.low > least) {
    served.low = std::min(problem.p, served.low * (1 + edge_rounding));
  }
  if (*served.high < most) {
    served.high = std::max(stiffest, *served.high * (1 - edge_rounding));
  }
  return served;
}

}  // namespace

DamperRooms::DamperRooms(const PulseProblem& problem, const Limits& limits, double friction,
                         double point_friction)
    : f(friction),
      delta(point_friction * for_rounding),
      beta(problem.beta * for_rounding),
      criterion(problem.criterion) {
  std::ranges::transform(limited_figures, figures_max.begin(), [&](const LimitKind* kind) {
    return limit_or_infinity(*kind, limits) * for_rounding;
  });
}

double DamperRooms::peak(const FirstReturn& motion, double k, double p) const {
  return room_of(motion.peak * (k / p / p), beta);
}

double DamperRooms::stop(const FirstReturn& motion, double k, double p, Criterion by) const {
  return motion.returns ? room_of(motion.need(by) * (k / p / p * k), delta) : -1;
}

double DamperRooms::room(const FirstReturn& motion, double k, double p) const {
  double least = std::min(peak(motion, k, p), stop(motion, k, p, criterion));
  for (std::size_t i = 0; i < figure_count; ++i) {
    const double figure = motion.*limited_figures[i]->figure->under_pulse * k;
    least = std::min(least, room_of(figure, figures_max[i]));
  }
  return least;
}

double farthest_k(const DamperRooms& damper, const FirstReturn& motion, double p) {
  return most(damper.beta, motion.peak) * p * p;
}

double stopped_k(const DamperRooms& damper, const FirstReturn& motion, double p, Criterion by) {
  return motion.returns ? std::sqrt(most(damper.delta, motion.need(by))) * p : 0;
}

WorstReturn for_any_k(PulseProblem problem) {
  problem.ranges.k_low = {};
  return WorstReturn(problem, true);
}

Interval searched_p(const PulseProblem& problem) {
  // A full sine moves the mass there and back however soft the spring is; a period a hundred times
  // as long is of no use.
  constexpr double softer = 1e-2;
  const double lambda = angular_frequency(problem.pulse);
  const double stiffest = problem.p_high.value_or(problem.p);
  const Interval valid = valid_p({.v0 = peak_load(problem.pulse) / lambda, .beta = problem.beta});
  const double shortest = problem.ranges.lambda_high.value_or(lambda);
  return {std::min(problem.p, std::max({valid.low, problem.p * softer, shortest / fastest_pulse})),
          std::max(stiffest, std::min(valid.high, lambda * slowest_examined))};
}

std::optional<WorksFor> works_for(const PulseProblem& problem, const Limits& limits, double f,
                                  double delta) {
  const DamperRooms damper(problem, limits, f, delta);
  const double k = peak_load(problem.pulse);
  const bool kept = f < problem.ranges.k_low.value_or(k) && f <= least_limit(Bounded::f, limits) &&
                    delta <= least_limit(Bounded::delta, limits) &&
                    damper.room(worst_motion(problem, f / k), k, problem.p) >= 0;
  return kept ? std::optional(
                    WorksFor{served_k(problem, damper), served_p(problem, damper), ServedLoad::k})
              : std::nullopt;
}

}  // namespace stillpoint::design
