// SPDX-License-Identifier: MIT
// Parts of a catalogue under a pulse: docs/theory.md section 15.

#include "pulse/answer.hpp"
#include "ranking.hpp"
#include "region/limit_table.hpp"
#include "region/mend_list.hpp"
#include "search/objectives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

/// Of beta, and of each row of the table of limits, in the units of the request.
using OfLimits = std::array<double, 1 + limit_table.size()>;

struct TriedPart {
  RatedPart rated;
  bool stops{false};
  OfLimits used{};  ///< by its box
};

/// The figures of a motion are kept away from their limits like the edges of the region.
constexpr double within_limits = 1 - 2e-13;

OfLimits allowed(const PulseRequest& request) {
  OfLimits most{request.problem.beta * within_limits};
  for (std::size_t i = 0; i < limit_table.size(); ++i) {
    most[i + 1] = limit_or_infinity(limit_table[i], request.limits) *
                  (limit_table[i].figure ? within_limits : 1);
  }
  return most;
}

bool part_fits(const TriedPart& now, const OfLimits& most) {
  return now.stops && std::equal(now.used.begin(), now.used.end(), most.begin(), std::less_equal());
}

TriedPart tried(const PulseRequest& request, const PulseRegion& region, const Part& part) {
  const auto& [problem, limits, options] = request;
  require_valid(part, problem.p);
  const double unit_f = part.f / region.f_unit();
  const double unit_delta = part.delta / region.delta_unit();
  const double tolerance = limits.tolerance;
  TriedPart now{{part, false, {}, {}}};
  if (unit_f < 1) {
    const double high = region.high_of(unit_f, tolerance);
    const FirstReturn box =
        region.profile()->between(region.low_of(unit_f, tolerance), std::min(1.0, high));
    now.stops =
        box.returns && high < 1 &&
        box.need(problem.criterion) <= unit_delta * (1 - limits.shape.delta_low * tolerance);
    now.used[0] = box.peak * region.length_unit();
    for (std::size_t i = 0; i < limit_table.size(); ++i) {
      const LimitKind& kind = limit_table[i];
      now.used[i + 1] = kind.figure       ? box.*kind.figure->under_pulse * region.f_unit()
                        : kind.bounds_f() ? region.high_of(part.f, tolerance)
                                          : part.delta * (1 + limits.shape.delta_high * tolerance);
    }
    now.rated.tolerance = region.tolerance_of(unit_f, unit_delta);
  }
  if (!now.rated.tolerance) {
    now.rated.violated =
        constraints_of(request, {part.f, part.delta, 0}, motion_at(region, unit_f), region);
    std::erase_if(now.rated.violated, [](const Constraint& row) { return row.satisfied; });
    if (now.rated.violated.empty()) {  // it is on an edge
      now.rated.tolerance = 0;
    }
  }
  now.rated.admissible = now.rated.tolerance && part_fits(now, allowed(request));
  return now;
}

double cost_under_pulse(const PulseRegion& region, Objective objective, const RatedPart& rated) {
  return objective == Objective::robust
             ? -rated.tolerance.value_or(0)
             : objective_of(objective, region.at(rated.part.f / region.f_unit()));
}

/// A limit bounds one figure of a box, and its least change is the smallest such figure among the
/// parts that meet all the other limits.
std::vector<Mend> mends_of_parts(const PulseRequest& request, const std::vector<TriedPart>& parts) {
  const Limits& limits = request.limits;
  std::vector<Mend> list;
  const auto add = [&](std::size_t row, std::string_view field) {
    OfLimits others = allowed(request);
    others[row] = HUGE_VAL;
    double least = HUGE_VAL;
    for (const TriedPart& now : parts) {
      least = part_fits(now, others) ? std::min(least, now.used[row]) : least;
    }
    constexpr double outside = 1 + 1e-11;
    if (std::isfinite(least)) {
      list.push_back({field, least / within_limits * outside, true});
    }
  };
  add(0, "beta");
  const auto most = std::ranges::max(parts, {}, [](const TriedPart& now) {
                      return now.rated.tolerance;
                    }).rated.tolerance;
  if (most && *most < limits.tolerance) {
    constexpr double less = 1 - 1e-10;
    list.push_back({"tolerance", *most * less, false});
  }
  for (std::size_t i = 0; i < limit_table.size(); ++i) {
    if (limits.*limit_table[i].value) {
      add(i + 1, limit_table[i].field);
    }
  }
  return list;
}

}  // namespace

Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts) {
  const PulseRegion region = region_for(request);
  std::vector<TriedPart> all;
  std::vector<RatedPart> rated;
  all.reserve(parts.size());
  rated.reserve(parts.size());
  for (const Part& part : parts) {
    rated.push_back(all.emplace_back(tried(request, region, part)).rated);
  }
  // Of several intervals, the one with the most tolerant damper, as in `region`.
  const auto most_tolerant = search(region, {});
  Choice choice{without_finding(request, region, most_tolerant),
                best_first(std::move(rated), [&](const RatedPart& now) {
                  return cost_under_pulse(region, request.search.objective, now);
                })};
  const RatedPart& best = choice.parts.front();
  if (best.admissible) {
    const auto& [name, f, delta] = best.part;
    add_finding(choice.result, request, region, {f, delta, *best.tolerance}, f / region.f_unit());
    return choice;
  }
  if (!choice.result.reason) {
    choice.result.reason = none_admissible(parts.size());
  }
  choice.result.mends = mends_of_parts(request, all);
  choice.result.criterion_mend = exact_if_it_fits(request, [&](const PulseRequest& exact) {
    const PulseRegion other(exact.problem, exact.limits);
    return std::ranges::any_of(
        parts, [&](const Part& part) { return tried(exact, other, part).rated.admissible; });
  });
  return choice;
}

}  // namespace stillpoint::design
