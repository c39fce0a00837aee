// SPDX-License-Identifier: MIT
// Parts of a catalogue under a pulse: docs/theory.md section 15.

#include "pulse/catalogue.hpp"

#include "finding.hpp"
#include "pulse/region.hpp"
#include "pulse/search.hpp"
#include "pulse/verdict.hpp"
#include "ranking.hpp"
#include "search/objectives.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

/// A part with what its whole box requires, in the units of the request, without the limits.
struct TriedPart {
  RatedPart rated;
  FirstReturn motion;  ///< of the part itself
  bool returns{false};
  double peak{0};
  double acceleration{0};
  double f{0};
  double delta{0};
  bool stops{false};
};

class Trial {
 public:
  explicit Trial(const PulseRequest& request)
      : request_(request), region_(request.problem, request.limits) {}

  [[nodiscard]] const PulseRegion& region() const { return region_; }

  [[nodiscard]] TriedPart tried(const Part& part) const {
    const auto& [problem, limits, options] = request_;
    require_valid(part, problem.p);
    const double unit_f = part.f / region_.f_unit();
    const double unit_delta = part.delta / region_.delta_unit();
    const double tolerance = limits.tolerance;
    TriedPart tried{{part, false, {}, {}}, motion_at(region_, unit_f)};
    if (unit_f < 1) {
      const double high = region_.high_of(unit_f, tolerance);
      const FirstReturn box =
          region_.profile()->between(region_.low_of(unit_f, tolerance), std::min(1.0, high));
      tried.returns = box.returns && high < 1;
      tried.peak = box.peak * region_.length_unit();
      tried.acceleration = box.acceleration * region_.f_unit();
      tried.stops =
          box.need(problem.criterion) <= unit_delta * (1 - limits.shape.delta_low * tolerance);
      tried.rated.tolerance = region_.tolerance_of(unit_f, unit_delta);
    }
    tried.f = region_.high_of(part.f, tolerance);
    tried.delta = part.delta * (1 + limits.shape.delta_high * tolerance);
    tried.rated.admissible = tried.rated.tolerance && fits(tried, problem.beta, limits);
    if (!tried.rated.tolerance) {
      tried.rated.violated = violated(part, tried.motion);
    }
    return tried;
  }

  /// The part with its box, for another beta or other limits than those asked for.
  [[nodiscard]] static bool fits(const TriedPart& now, double beta, const Limits& limits) {
    return now.returns && now.stops && now.peak <= beta * inside &&
           now.f <= limits.f_max.value_or(HUGE_VAL) * inside &&
           now.delta <= limits.delta_max.value_or(HUGE_VAL) * inside &&
           now.acceleration <= limits.acceleration_max.value_or(HUGE_VAL) * inside;
  }

  /// Kept away from the limits like the edges of the region, so that whatever fits has a tolerance.
  static constexpr double inside = 1 - 2e-13;

 private:
  [[nodiscard]] std::vector<Constraint> violated(const Part& part,
                                                 const FirstReturn& motion) const {
    std::vector<Constraint> list =
        constraints_of(request_, {part.f, part.delta, 0}, motion, region_);
    std::erase_if(list, [](const Constraint& now) { return now.satisfied; });
    return list;
  }

  const PulseRequest& request_;
  PulseRegion region_;
};

double cost_under_pulse(const Trial& trial, const PulseRequest& request, const RatedPart& rated) {
  const auto objective = request.search.objective;
  if (objective == Objective::robust) {
    return -rated.tolerance.value_or(0);
  }
  return objective_of(objective, trial.region().at(rated.part.f / trial.region().f_unit()));
}

/// A limit bounds one figure of a box, and its least change is the smallest such figure among the
/// parts that meet all the other limits.
std::vector<Mend> mends_of_parts(const PulseRequest& request, const std::vector<TriedPart>& parts) {
  const auto& [problem, limits, options] = request;
  std::vector<Mend> list;
  const auto add = [&](std::string_view field, double beta, const Limits& others,
                       double TriedPart::*figure) {
    double least = HUGE_VAL;
    for (const TriedPart& now : parts) {
      if (Trial::fits(now, beta, others)) {
        least = std::min(least, now.*figure);
      }
    }
    constexpr double outside = 1 + 1e-11;
    if (std::isfinite(least)) {
      list.push_back({field, least / Trial::inside * outside, true});
    }
  };
  add("beta", HUGE_VAL, limits, &TriedPart::peak);
  if (limits.tolerance > 0) {
    std::optional<double> most;
    for (const TriedPart& now : parts) {
      most = std::max(most, now.rated.tolerance);
    }
    constexpr double less = 1 - 1e-10;
    if (most && *most < limits.tolerance) {
      list.push_back({"tolerance", *most * less, false});
    }
  }
  const auto without = [&given = limits](std::optional<double> Limits::*limit) {
    Limits others = given;
    others.*limit = std::nullopt;
    return others;
  };
  if (limits.f_max) {
    add("f_max", problem.beta, without(&Limits::f_max), &TriedPart::f);
  }
  if (limits.delta_max) {
    add("delta_max", problem.beta, without(&Limits::delta_max), &TriedPart::delta);
  }
  if (limits.acceleration_max) {
    add("acceleration_max", problem.beta, without(&Limits::acceleration_max),
        &TriedPart::acceleration);
  }
  return list;
}

}  // namespace

Choice choose_under_pulse(const PulseRequest& request, std::span<const Part> parts) {
  const auto& [problem, limits, options] = request;
  require_valid(options);
  require_valid(problem, limits);
  const Trial trial(request);
  const PulseRegion& region = trial.region();
  std::vector<TriedPart> tried;
  std::vector<RatedPart> rated;
  tried.reserve(parts.size());
  rated.reserve(parts.size());
  for (const Part& part : parts) {
    rated.push_back(tried.emplace_back(trial.tried(part)).rated);
  }
  // Of several intervals, the one with the most tolerant damper, as in `region`.
  const auto most_tolerant = search(region, {});
  Choice choice{
      without_finding(request, region,
                      most_tolerant ? std::optional(most_tolerant->island) : std::nullopt),
      best_first(std::move(rated),
                 [&](const RatedPart& now) { return cost_under_pulse(trial, request, now); })};
  const RatedPart& best = choice.parts.front();
  if (best.admissible) {
    const auto& [name, f, delta] = best.part;
    add_finding(choice.result, request, region, {{f, delta, *best.tolerance}, {}},
                f / region.f_unit());
    return choice;
  }
  if (choice.result.reason.empty()) {
    choice.result.reason = none_admissible(parts.size());
  }
  choice.result.mends = mends_of_parts(request, tried);
  return choice;
}

}  // namespace stillpoint::design
