// SPDX-License-Identifier: MIT
#include "pulse/answer.hpp"

#include "region/reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// The last f that returns, and the motion there.
FirstReturn last_return(const PulseRegion& region) {
  FirstReturn last;
  for (const FirstReturn& now : region.profile()->samples()) {
    last = now.returns ? now : last;
  }
  return last;
}

/// Up to there it returns, over k. Under a full sine that is the k of the weakest pulse.
double largest_f(const PulseRegion& region) {
  // An f_max that returns between samples that do not has an island of its own.
  const auto& islands = region.islands();
  const double last = std::max(last_return(region).f, islands.empty() ? 0 : islands.back().high);
  const double weakest = region.profile()->weakest();
  return last >= nearest_to_k * weakest * (1 - edge_rounding) ? weakest : last;
}

/// A task with only some of its requirements.
bool leaves_any(const PulseRegion& region, PulseProblem problem, const Limits& limits, bool beta) {
  if (!beta) {
    problem.beta = HUGE_VAL;
  }
  return PulseRegion(region.profile(), problem, limits).feasible();
}

/// Without an island the edges are those of all f.
Region edges_of(const PulseRegion& region, const PulseProblem& problem,
                const std::optional<PulseOptimum>& within) {
  Region edges;
  const FirstReturn last = last_return(region);
  double least_peak = last.peak;
  const FirstReturn* weakest = nullptr;
  for (const FirstReturn& now : region.profile()->samples()) {
    if (now.returns) {
      least_peak = std::min(least_peak, now.peak);
      weakest = weakest == nullptr ? &now : weakest;
    }
  }
  edges.f1 = problem.beta * problem.p * problem.p;
  edges.f3 = largest_f(region) * region.f_unit();
  // Near k the mass moves arbitrarily little.
  edges.beta_min = edges.f3 < region.f_unit() ? least_peak * region.length_unit() : 0;
  if (within) {
    edges.feasible = true;
    const bool binds = weakest != nullptr && within->island.low > weakest->f * (1 + 1e-9);
    edges.f2 = binds ? within->island.low * region.f_unit() : 0;
    KnownMotions known(*region.profile());
    const auto parts = region.parts(within->island, region.asked(), 1, known);
    const auto part = std::ranges::find_if(parts, [&](const Island& now) {
      return now.low <= within->found.point.f && within->found.point.f <= now.high;
    });
    const Island middles =
        region.middles(part == parts.end() ? within->island : *part, region.asked());
    edges.f_lower = middles.low * region.f_unit();
    edges.f_upper = middles.high * region.f_unit();
    edges.f_lower = std::min(*edges.f_lower, *edges.f_upper);
  }
  return edges;
}

/// The first requirement that leaves nothing, in the order of the sentences of `reason_of`.
void explain(Region& found, const PulseRegion& region, const PulseProblem& problem,
             const Limits& limits) {
  Limits some{.tolerance = limits.tolerance, .shape = limits.shape};
  const auto fits = [&](const Limits& now, bool beta = true) {
    return leaves_any(region, problem, now, beta);
  };
  const auto because = [&](Conflict conflict, const LimitKind* limit) {
    found.conflict = conflict;
    found.limit = limit;
  };
  if (!fits(some)) {
    return because(Conflict::amplitude_against_return, nullptr);
  }
  const Limits none = some;
  for (const LimitKind& kind : limit_table) {
    if (!kind.bounds_f() || !(limits.*kind.value)) {
      continue;
    }
    Limits alone = none;
    alone.*kind.value = some.*kind.value = limits.*kind.value;
    if (kind.figure && !fits(alone, false)) {
      return because(Conflict::limit_alone, &kind);
    }
    if (!fits(some)) {
      return because(Conflict::amplitude_against_limit, &kind);
    }
  }
  const auto* const by_delta = std::ranges::find(limit_table, Bounded::delta, &LimitKind::bounds);
  because(Conflict::stop_against_limit, &*by_delta);
}

std::string reason_of(const Region& found, const PulseRegion& region, const PulseProblem& problem,
                      const Limits& limits) {
  const bool even = limits.shape == BoxShape{};
  const std::string box = limits.tolerance > 0 && even
                              ? fmt::format(", with a tolerance of {:g} %", 100 * limits.tolerance)
                          : limits.tolerance > 0 ? ", with the tolerances asked for"
                                                 : "";
  const PulseRegion amplitude(region.profile(), problem, {});
  const double k = region.f_unit();
  const FirstReturn last = last_return(region);
  const LimitKind* const kind = found.limit;
  const double limit = kind == nullptr ? 0 : (limits.*kind->value).value_or(0);
  constexpr std::string_view stroke = "a peak within the displacement allowed needs";
  switch (found.conflict) {
    case Conflict::amplitude_against_return:
      if (amplitude.islands().empty()) {
        return fmt::format(
            "coming back to x = 0 needs f <= {:.6g}, and then the peak is at least {:.6g} times "
            "the largest displacement allowed",
            last.f * k, last.peak * region.length_unit() / problem.beta);
      }
      return fmt::format(
          "{} f >= {:.6g}, but coming back to x = 0 needs f <= {:.6g}{}", stroke,
          amplitude.islands().front().low * k, amplitude.islands().back().high * k,
          none_between("f", amplitude.islands().front().low, amplitude.islands().back().high, box));
    case Conflict::limit_alone:
      return fmt::format("no f brings the mass back and keeps the {} within {:.6g}{}{}",
                         kind->quantity, limit, kind->unit, box);
    case Conflict::amplitude_against_limit:
      return kind->figure
                 ? fmt::format(
                       "no f brings the mass back and keeps the peak within the displacement "
                       "allowed and the {} within {:.6g}{}{}",
                       kind->quantity, limit, kind->unit, box)
                 : fmt::format("{} f >= {:.6g}, but f may be at most {:.6g}{}", stroke,
                               amplitude.islands().front().low * k, limit,
                               none_between("f", amplitude.islands().front().low * k, limit, box));
    default:
      return kind->bounds == Bounded::delta && limit == 0
                 ? "without a notch (delta = 0) the mass rests up to f/p^2 off centre, not at "
                   "x = 0, where a design for a pulse stops it"
                 : "at every f that meets the other requirements the mass arrives too fast for a "
                   "notch with the largest delta allowed" +
                       box;
  }
}

/// The end, nearest to f, of the interval of returning f that it is in, or of either beside it.
Constraint return_of(const PulseRegion& region, const FirstReturn& motion, double f) {
  std::vector<FirstReturn> all = region.profile()->samples();
  insert(all, {motion});
  Constraint nearest{"return", "f", "<=", f, HUGE_VAL, 0, motion.returns};
  const auto consider = [&](double end, bool upper) {
    const double limit = end == motion.f ? f : end * region.f_unit();
    const auto apart = [f](double from) { return std::max(from / f, f / from); };
    if (std::isinf(nearest.limit) || apart(limit) < apart(nearest.limit)) {
      nearest.limit = limit;
      nearest.relation = upper ? "<=" : ">=";
      nearest.slack = upper ? limit - f : f - limit;
    }
  };
  for (std::size_t i = 1; i < all.size(); ++i) {
    const FirstReturn& a = all[i - 1];
    const FirstReturn& b = all[i];
    const bool upper = a.returns;
    const double end = (upper ? a : b).f;
    if (a.returns != b.returns && (end >= motion.f) == (upper == motion.returns)) {
      consider(end, upper);
    }
  }
  if (all.back().returns) {
    consider(largest_f(region), true);
  }
  return nearest;
}

}  // namespace

std::optional<double> reduced_v0(const Pulse& pulse, double f) {
  const auto start = equivalent_start(pulse, f);
  return start ? std::optional(start->speed) : std::nullopt;
}

DesignResult without_finding(const PulseRequest& request, const PulseRegion& region,
                             const std::optional<PulseOptimum>& within) {
  const auto& [problem, limits, options] = request;
  const Problem task{.p = problem.p,
                     .beta = problem.beta,
                     .criterion = problem.criterion,
                     .p_high = problem.p_high};
  DesignResult result{{edges_of(region, problem, within)},
                      {task, limits, options, problem.pulse, problem.ranges},
                      {},
                      reduced_v0(problem.pulse, 0)};
  result.intervals.emplace();
  result.intervals->reserve(region.islands().size());
  KnownMotions known(*region.profile());
  for (const Island& island : region.islands()) {
    for (const auto& [low, high] : region.parts(island, 0, 1, known)) {
      result.intervals->push_back({low * region.f_unit(), high * region.f_unit()});
    }
  }
  if (!within) {
    explain(result.region, region, problem, limits);
    result.reason = reason_of(result.region, region, problem, limits);
  }
  return result;
}

FirstReturn motion_at(const PulseRegion& region, double unit_f) {
  FirstReturn still;
  still.f = unit_f;
  return unit_f < 1 ? region.at(unit_f) : still;
}

std::vector<Constraint> constraints_of(const PulseRequest& request, const DesignPoint& point,
                                       const FirstReturn& motion, const PulseRegion& region) {
  const auto& [problem, limits, options] = request;
  const auto below = [](std::string_view name, std::string_view variable, double value,
                        double limit) {
    return Constraint::compared(name, variable, "<=", value, limit);
  };
  std::vector<Constraint> list{
      Constraint::compared("start", "f", "<", point.f,
                           problem.ranges.k_low.value_or(peak_load(problem.pulse))),
      below("amplitude", "peak", motion.peak * region.length_unit(), problem.beta)};
  if (list.front().satisfied) {
    list.push_back(return_of(region, motion, point.f));
  }
  if (motion.returns) {
    list.push_back(Constraint::compared("stop", "delta", ">=", point.delta,
                                        motion.need(problem.criterion) * region.delta_unit()));
    Constraint& stop = list.back();
    stop.by_criterion_alone =
        !stop.satisfied && point.delta >= motion.exact_need * region.delta_unit();
  }
  for (const LimitKind& kind : limit_table) {
    const auto& limit = limits.*kind.value;
    if (!limit) {
      continue;
    }
    if (!kind.figure) {
      list.push_back(kind.bounds_f() ? below(kind.constraint, "f", point.f, *limit)
                                     : below(kind.constraint, "delta", point.delta, *limit));
    } else if (motion.f < 1) {
      list.push_back(below(kind.constraint, kind.constraint,
                           motion.*kind.figure->under_pulse * region.f_unit(), *limit));
    }
  }
  return list;
}

}  // namespace stillpoint::design
