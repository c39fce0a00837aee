// SPDX-License-Identifier: MIT
#include "record/first_return_task.hpp"

#include "pulse/region.hpp"
#include "record/suite_request.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr std::array objectives{std::pair(SuiteObjective::robust, Objective::robust),
                                std::pair(SuiteObjective::amplitude, Objective::amplitude),
                                std::pair(SuiteObjective::acceleration, Objective::acceleration),
                                std::pair(SuiteObjective::time, Objective::time)};

/// A task that is mended has dampers of this tolerance more than it asks for: of a single one the
/// box could not be verified.
constexpr double to_find = 5e-4;

/// Whether what is searched has no ends but those that the load and the limits set.
bool searches_all(const RecordDesignRequest& task) {
  RecordDesignRequest open = task;
  open.f = open.delta = std::nullopt;
  open = completed(std::move(open));
  return open.f == task.f && open.delta == task.delta && task.f->high > 0 && task.delta->high > 0;
}

bool stops_at_once(const RecordDesignRequest& task) {
  const LoadCase& only = task.cases.front();
  const SuiteLimits& limits = only.limits;
  const Spread& period = task.tolerance.period;
  // The most of an acceleration that damping adds to may lie between the ends of its range.
  const bool knows_worst =
      task.zeta.low == task.zeta.high ||
      (only.v0 && !limits.acceleration && task.objective != SuiteObjective::acceleration);
  return task.cases.size() == 1 && !only.of_records() && only.weakest > 0 && limits.peak &&
         limits.residual == 0.0 && limits.passages == 0.0 && !limits.jump && !limits.stop_time &&
         !limits.late && task.p.low == task.p.high && !task.hold && !task.width &&
         task.breakaway == 1 && period.below + period.above == 0 && knows_worst;
}

}  // namespace

std::optional<FirstReturnTask> FirstReturnTask::of(const RecordDesignRequest& task) {
  const auto* const objective =
      std::ranges::find(objectives, task.objective, [](const auto& row) { return row.first; });
  if (task.judges || task.maps || objective == objectives.end() || !stops_at_once(task) ||
      !searches_all(task)) {
    return std::nullopt;
  }
  const LoadCase& only = task.cases.front();
  FirstReturnTask known;
  known.p_ = task.p.low;
  known.objective_ = objective->second;
  PulseProblem& problem = known.problem_;
  problem.p = known.p_ / (1 + task.spring.above);
  problem.pulse = only.v0 ? pulse_of_hit(*only.v0, known.p_) : *only.pulse;
  problem.of_hit = only.v0.has_value();
  problem.beta = *only.limits.peak;
  problem.criterion = Criterion::exact;
  problem.zeta = task.zeta;
  if (only.weakest < 1) {
    problem.ranges.k_low = only.weakest * peak_load(problem.pulse);
  }
  if (task.spring.above + task.spring.below > 0) {
    problem.p_high = known.p_ / (1 - task.spring.below);
  }
  Limits& limits = known.limits_;
  limits.f_max = task.f_max;
  limits.delta_max = task.delta_max;
  limits.acceleration_max = only.limits.acceleration;
  const auto& [f, delta, width, period] = task.tolerance;
  if (f.below + f.above + delta.below + delta.above > 0) {
    shape_box(limits, f, delta);
  }
  known.whole_ = limits.tolerance;
  if (!known.problem_.of_hit && !task.delta_max) {  // what a design itself may have
    limits.delta_max = task.delta->high;
    limits.shape.delta_high = 0;
    known.bounds_delta_itself_ = true;
  }
  if (task.objective == SuiteObjective::robust && !task.requires_tolerance) {
    limits.tolerance = 0;
  }
  return known;
}

std::optional<DamperAlongF> FirstReturnTask::best() const {
  const PulseRegion region(problem_, limits_);
  const auto optimum = search(region, {.objective = objective_});
  if (!optimum) {
    return std::nullopt;
  }
  const DesignPoint point = region.in_units(optimum->found.point);
  return DamperAlongF{{.p = p_, .f = point.f, .delta = point.delta},
                      whole_ > 0 ? point.tolerance / whole_ : 1};
}

std::vector<Mend> FirstReturnTask::mends() const {
  PulseProblem problem = problem_;
  Limits limits = limits_;
  limits.tolerance += to_find;
  problem.beta *= 1 - to_find;
  if (limits.acceleration_max) {
    *limits.acceleration_max *= 1 - to_find;
  }
  std::vector<Mend> list =
      design::mends(problem, limits, std::make_shared<const WorstReturn>(problem)).list;
  std::erase_if(list, [&](const Mend& each) {
    return (each.field == "tolerance" && each.value < to_find) ||
           (each.field == "delta_max" && bounds_delta_itself_);
  });
  constexpr std::array names{std::pair("k", "v0"), std::pair("k_low", "v0_low"),
                             std::pair("k_high", "v0_high")};
  for (Mend& each : list) {
    each.value -= each.field == "tolerance" ? to_find : 0;
    each.value /= each.field == "beta" || each.field == "acceleration_max" ? 1 - to_find : 1;
    const auto* const name = std::ranges::find(
        names, each.field, [](const auto& row) { return std::string_view(row.first); });
    if (problem_.of_hit && name != names.end()) {
      each.field = name->second;
      each.value = hit_of(with(problem_.pulse, each.value, angular_frequency(problem_.pulse)));
    }
  }
  return list;
}

}  // namespace stillpoint::design
