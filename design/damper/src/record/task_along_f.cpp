// SPDX-License-Identifier: MIT
#include "record/task_along_f.hpp"

#include "pulse/region.hpp"
#include "record/suite_request.hpp"
#include "way/room.hpp"
#include "way/way.hpp"

#include <stillpoint/design/region.hpp>
#include <stillpoint/design/search.hpp>
#include <stillpoint/design/strips.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <tuple>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr std::array objectives{std::pair(SuiteObjective::robust, Objective::robust),
                                std::pair(SuiteObjective::amplitude, Objective::amplitude),
                                std::pair(SuiteObjective::acceleration, Objective::acceleration),
                                std::pair(SuiteObjective::time, Objective::time)};

/// The limits of which a mend leaves a part.
constexpr std::array<std::string_view, 3> shrunk{"beta", "acceleration_max", "residual"};

/// Whether what is searched has no ends but those that the load and the limits set.
bool searches_all(const RecordDesignRequest& task) {
  const RecordDesignRequest open = with_open_friction(task);
  return open.f == task.f && open.delta == task.delta && task.f->high > 0 && task.delta->high > 0;
}

/// Of a pulse the first return alone. Of a hit also later arrivals, and rests off centre where the
/// spring does not vary; the time to rest has no closed bound with damping.
bool is_known(const RecordDesignRequest& task, const LoadCase& only) {
  const auto& [residual, passages] = std::tie(only.limits.residual, only.limits.passages);
  const bool varies = task.spring.above + task.spring.below > 0;
  return only.v0 ? residual && passages.value_or(HUGE_VAL) < most_damped_arrivals &&
                       (residual == 0.0 || !varies)
                 : residual == 0.0 && passages == 0.0 && only.weakest > 0 &&
                       task.zeta.low == task.zeta.high;
}

/// Up to twice f breakaway friction holds no mass that could have come back to x = 0, (D16); which
/// rests off centre it decides, the edges know.
bool slides_off(const RecordDesignRequest& task, const LoadCase& only) {
  constexpr double most = 2;
  return task.breakaway == 1 || (task.breakaway <= most && only.v0);
}

bool is_along_f(const RecordDesignRequest& task) {
  const LoadCase& only = task.cases.front();
  const SuiteLimits& limits = only.limits;
  const Spread& period = task.tolerance.period;
  return task.cases.size() == 1 && !only.of_records() && limits.peak && is_known(task, only) &&
         !limits.jump && !limits.stop_time && !limits.late && task.p.low == task.p.high &&
         !task.hold && !task.width && slides_off(task, only) && period.below + period.above == 0;
}

}  // namespace

std::vector<double> values_in(const Interval& range, std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count && (i == 0 || range.low < range.high); ++i) {
    values.push_back(
        std::lerp(range.low, range.high, static_cast<double>(i) / static_cast<double>(count - 1)));
  }
  return values;
}

std::optional<TaskAlongF> TaskAlongF::of(const RecordDesignRequest& task) {
  const auto* const objective =
      std::ranges::find(objectives, task.objective, [](const auto& row) { return row.first; });
  if (task.judges || objective == objectives.end() || !is_along_f(task) || !searches_all(task) ||
      (task.cases.front().v0 && objective->second == Objective::time)) {
    return std::nullopt;
  }
  TaskAlongF known = posed(task);
  known.objective_ = objective->second;
  if (known.objective_ == Objective::robust && !task.requires_tolerance) {
    known.limits_.tolerance = 0;
  }
  return known;
}

TaskAlongF TaskAlongF::posed(const RecordDesignRequest& task) {
  const LoadCase& only = task.cases.front();
  const double softest = task.p.low / (1 + task.spring.above);
  const std::optional<double> stiffest = task.spring.above + task.spring.below > 0
                                             ? std::optional(task.p.low / (1 - task.spring.below))
                                             : std::nullopt;
  const auto weakest_of = [&](double load) {
    return only.weakest < 1 ? std::optional(only.weakest * load) : std::nullopt;
  };
  TaskAlongF known;
  known.p_ = task.p.low;
  Limits& limits = known.limits_;
  limits.f_max = task.f_max;
  limits.delta_max = task.delta_max;
  limits.acceleration_max = only.limits.acceleration;
  const auto& [f, delta, width, period] = task.tolerance;
  if (f.below + f.above + delta.below + delta.above > 0) {
    shape_box(limits, f, delta);
  }
  known.whole_ = limits.tolerance;
  if (only.v0) {
    auto& hit = known.problem_.emplace<Problem>();
    hit = {*only.v0, softest, *only.limits.peak, Criterion::exact};
    hit.arrivals = static_cast<std::int64_t>(*only.limits.passages) + 1;
    hit.v0_low = weakest_of(*only.v0);
    hit.p_high = stiffest;
    hit.residual = only.limits.residual > 0.0 ? only.limits.residual : std::nullopt;
    hit.zeta = task.zeta;
    hit.breakaway = task.breakaway;
  } else {
    auto& pulse = known.problem_.emplace<PulseProblem>();
    pulse = {*only.pulse, softest, *only.limits.peak, Criterion::exact};
    pulse.ranges.k_low = weakest_of(peak_load(pulse.pulse));
    pulse.p_high = stiffest;
    pulse.zeta = task.zeta.low;
    if (!task.delta_max) {  // what a design itself may have
      limits.delta_max = task.delta->high;
      limits.shape.delta_high = 0;
      known.bounds_delta_itself_ = true;
    }
  }
  return known;
}

std::optional<WorksFor> TaskAlongF::works_for(const RecordDesignRequest& task,
                                              const SuiteDamper& damper) {
  if (!is_along_f(task) || !task.cases.front().v0) {
    return std::nullopt;
  }
  // Of springs too, of which the tightest rest is not known with a breakaway.
  if (task.breakaway > 1 && task.cases.front().limits.residual > 0.0) {
    return std::nullopt;
  }
  const TaskAlongF known = posed(task);
  Limits limits = known.limits_;
  limits.tolerance = 0;
  return design::works_for(std::get<Problem>(known.problem_), limits, damper.f, damper.delta);
}

std::optional<DesignPoint> TaskAlongF::without_friction() const {
  const auto& hit = std::get<Problem>(problem_);
  if (hit.arrivals == 1) {
    return std::nullopt;
  }
  const DesignPoint point = with_best_delta(Way(hit, limits_, 0), 0);
  return point.tolerance > 0 && point.tolerance >= limits_.tolerance ? std::optional(point)
                                                                     : std::nullopt;
}

std::optional<DesignPoint> TaskAlongF::searched(Objective objective) const {
  const auto* const hit = std::get_if<Problem>(&problem_);
  if (hit == nullptr) {
    const PulseRegion region(std::get<PulseProblem>(problem_), limits_);
    const auto optimum = search(region, {.objective = objective});
    return optimum ? std::optional(region.in_units(optimum->found.point)) : std::nullopt;
  }
  const auto found = search(*hit, limits_, {.objective = objective});
  const auto still = without_friction();
  const bool is_better =
      still && (!found || objective == Objective::acceleration ||
                (objective == Objective::robust && still->tolerance > found->point.tolerance));
  return is_better ? still : found ? std::optional(found->point) : std::nullopt;
}

std::vector<SuiteDamper> TaskAlongF::towards_room(const SuiteDamper& best) const {
  constexpr std::array parts{1e-3, 1e-2, 0.05, 0.2, 0.5, 1.0};
  const auto to = objective_ == Objective::robust ? std::nullopt : searched(Objective::robust);
  std::vector<SuiteDamper> list;
  for (const double part : parts) {
    if (to) {
      list.push_back({.p = p_,
                      .f = std::lerp(best.f, to->f, part),
                      .delta = std::lerp(best.delta, to->delta, part)});
    }
  }
  return list;
}

std::optional<DamperAlongF> TaskAlongF::best() const {
  const auto point = searched(objective_);
  return point ? std::optional(DamperAlongF{{.p = p_, .f = point->f, .delta = point->delta},
                                            whole_ > 0 ? point->tolerance / whole_ : 1})
               : std::nullopt;
}

std::optional<FeasibleRegion> TaskAlongF::feasible() const {
  const auto* const hit = std::get_if<Problem>(&problem_);
  if (hit == nullptr) {
    return std::nullopt;
  }
  const std::vector<Strip> all = strips(*hit, limits_);
  const std::vector<Interval> of_strips = feasible_f(all);
  FeasibleRegion region{of_strips, {}};
  if (without_friction()) {
    const auto delta = centre_range(Way(*hit, limits_, 0), 0, limits_.tolerance).value();
    const double unit = hit->v0 * hit->v0;
    region.deltas.push_back({0, {delta.low * unit, delta.high * unit}});
    if (region.f.empty() || region.f.front().low > 0) {
      region.f.insert(region.f.begin(), {0, 0});
    }
  }
  if (of_strips.empty()) {
    return region;
  }
  for (const double f :
       values_in({of_strips.front().low, of_strips.back().high}, told_values_of_f)) {
    std::vector<Interval> deltas;
    if (f == 0 && !region.deltas.empty()) {
      continue;  // told already
    }
    for (const Strip& strip : all) {
      const auto delta = feasible_delta(*hit, limits_, strip.arrival, f);
      if (delta && delta->low < delta->high) {
        deltas.push_back(*delta);
      }
    }
    for (const Interval& delta : merged(std::move(deltas))) {
      region.deltas.push_back({f, delta});
    }
  }
  return region;
}

std::vector<Mend> TaskAlongF::mends(double room) const {
  std::variant<Problem, PulseProblem> problem = problem_;
  Limits limits = limits_;
  limits.tolerance += room;
  if (limits.acceleration_max) {
    *limits.acceleration_max *= 1 - room;
  }
  std::visit([&](auto& one) { one.beta *= 1 - room; }, problem);
  std::vector<Mend> list;
  if (auto* const hit = std::get_if<Problem>(&problem)) {
    if (hit->residual) {
      *hit->residual *= 1 - room;
    }
    list = design::mends(*hit, limits);
  } else {
    const auto& pulse = std::get<PulseProblem>(problem);
    list = design::mends(pulse, limits, std::make_shared<const WorstReturn>(pulse)).list;
  }
  std::erase_if(list, [&](const Mend& each) {
    return (each.field == "tolerance" && each.value < room) ||
           (each.field == "delta_max" && bounds_delta_itself_);
  });
  for (Mend& each : list) {
    each.value -= each.field == "tolerance" ? room : 0;
    each.value /= std::ranges::find(shrunk, each.field) != shrunk.end() ? 1 - room : 1;
  }
  return list;
}

bool TaskAlongF::moves(const SuiteFigureKind& kind) const {
  return std::holds_alternative<Problem>(problem_) || kind.limit == &SuiteLimits::peak ||
         kind.limit == &SuiteLimits::acceleration;
}

}  // namespace stillpoint::design
