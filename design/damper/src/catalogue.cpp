// SPDX-License-Identifier: MIT
#include <stillpoint/design/catalogue.hpp>

#include "found.hpp"
#include "nearest_fit.hpp"
#include "pulse/answer.hpp"
#include "ranking.hpp"
#include "region/mend_list.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/region.hpp>

#include <algorithm>
#include <cmath>

namespace stillpoint::design {

namespace {

/// What the objective minimises; infinite for a motion that never stops.
double cost_of(const Problem& problem, Objective objective, const RatedPart& rated) {
  if (objective == Objective::robust) {
    return -*rated.tolerance;
  }
  const Response motion =
      free_response({problem.p, rated.part.f, rated.part.delta}, {0, problem.v0});
  return objective_of(objective, motion).value_or(HUGE_VAL);
}

RatedPart rated(const Problem& problem, const Limits& limits, const Part& part) {
  cancellation_point();
  require_valid(part, problem.p);
  RatedPart rated{part,
                  admissible(problem, limits, part.f, part.delta),
                  largest_tolerance(problem, limits, part.f, part.delta),
                  {}};
  if (!rated.tolerance) {
    const auto all = constraints(problem, limits, part.f, part.delta);
    const auto back = std::ranges::find(all, "return", &Constraint::name);
    for (const Constraint& now : all) {
      // A damper that does not return is not judged by Delta1, which has no meaning there.
      const bool meaningless = now.name == "stop" && now.variable == "delta" && !back->satisfied;
      if (!now.satisfied && !meaningless) {
        rated.violated.push_back(now);
      }
    }
  }
  return rated;
}

bool admits(const HitCase& now, const Part& part) {
  cancellation_point();
  return admissible(now.problem, now.limits, part.f, part.delta);
}

bool admits_any(const HitCase& now, std::span<const Part> parts) {
  return std::ranges::any_of(parts, [&](const Part& part) { return admits(now, part); });
}

/// Those whose change in one direction loosens the task for every part.
std::vector<Input<HitCase>> inputs_of(const HitCase& base) {
  const auto& [problem, limits] = base;
  std::vector<Input<HitCase>> list = limit_inputs<HitCase>(limits);
  if (limits.tolerance > 0) {
    std::rotate(list.begin(), list.end() - 1, list.end());
  }
  // No friction has a larger peak than V0/p.
  list.insert(list.begin(),
              {"beta", problem.beta, std::max(problem.beta, 2 * problem.v0 / problem.p),
               in_problem(&Problem::beta)});
  return list;
}

/// The value nearest to the one given with which some part fits; empty if none does even with the
/// loosest.
std::optional<double> least_change(const HitCase& base, const Input<HitCase>& input,
                                   std::span<const Part> parts) {
  std::optional<double> best;
  for (const Part& part : parts) {
    const auto nearest = nearest_fit(input.from, best.value_or(input.to), [&](double value) {
      return admits(input.in(base, value), part);
    });
    best = nearest ? nearest : best;
  }
  return best;
}

}  // namespace

std::vector<RatedPart> ranked(const Problem& problem, const Limits& limits, Objective objective,
                              std::span<const Part> parts) {
  require_valid(problem, limits);
  std::vector<RatedPart> all;
  all.reserve(parts.size());
  for (const Part& part : parts) {
    all.push_back(rated(problem, limits, part));
  }
  return best_first(std::move(all),
                    [&](const RatedPart& now) { return cost_of(problem, objective, now); });
}

std::vector<Mend> part_mends(const Problem& problem, const Limits& limits,
                             std::span<const Part> parts) {
  const HitCase base{problem, limits};
  if (admits_any(base, parts)) {
    return {};
  }
  std::vector<Mend> mends;
  for (const Input<HitCase>& input : inputs_of(base)) {
    if (const auto value = least_change(base, input, parts)) {
      mends.push_back(input.mend(*value));
    }
  }
  const auto with_arrivals = [&](std::int64_t n) {
    HitCase more = base;
    more.problem.arrivals = n;
    return admits_any(more, parts);
  };
  if (const auto mend = arrivals_mend(problem, with_arrivals)) {
    mends.push_back(*mend);
  }
  return mends;
}

Choice choose(const DesignRequest& request, std::span<const Part> parts) {
  const auto& [problem, limits, options, pulse, ranges] = request;
  if (parts.empty()) {
    throw InputError::missing("catalogue", "there must be at least one part");
  }
  if (pulse) {
    return choose_under_pulse(pulse_request(request), parts);
  }
  require_valid(options);
  Choice choice{{{admissible_region(problem, limits)}, request},
                ranked(problem, limits, options.objective, parts)};
  DesignResult& result = choice.result;
  const RatedPart& best = choice.parts.front();
  if (best.admissible) {
    const auto& [name, f, delta] = best.part;
    result.finding = finding_of(problem, limits, {f, delta, best.tolerance.value_or(0)});
    return choice;
  }
  result.reason = result.region.feasible ? none_admissible(parts.size())
                                         : design::reason(result.region, problem, limits);
  result.mends = part_mends(problem, limits, parts);
  result.criterion_mend = exact_if_it_fits(
      HitCase{problem, limits}, [&](const HitCase& exact) { return admits_any(exact, parts); });
  return choice;
}

}  // namespace stillpoint::design
