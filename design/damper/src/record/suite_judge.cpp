// SPDX-License-Identifier: MIT
#include "record/suite_judge.hpp"

#include "ranking.hpp"
#include "record/suite_request.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <utility>

namespace stillpoint::design {

namespace {

/// Of a damper without one whose largest is asked for, in which f and delta are off alike.
constexpr Spread usual_shape{0.1, 0.1};

SuiteDamper given_damper(const RecordDesignRequest& task) {
  const bool has_width = task.width && task.delta->low > 0;
  return {task.p.low, task.f->low, task.delta->low, has_width ? task.width->low : 0};
}

RecordDesignRequest without_bounds(RecordDesignRequest task) {
  task.f_max = task.delta_max = task.f_start = task.delta_start = std::nullopt;
  return task;
}

/// Whether a damper keeps what is asked of it, without its tolerance.
bool keeps_bounds(RecordDesignRequest task, const SuiteDamper& damper) {
  task.tolerance = {{}, {}, {}, {}};
  return std::ranges::all_of(constraints_on(task, damper), &Constraint::satisfied);
}

/// Of a damper that is admissible itself: halved to where a few of its box hold, then made smaller
/// until many do.
std::optional<double> largest_tolerance(const Suites& suite, RecordDesignRequest task,
                                        const SuiteDamper& damper, SuiteWatch& watch) {
  task.spring = combined(task.spring, std::exchange(task.tolerance.period, {}));
  if (task.tolerance.exact()) {
    task.tolerance.f = task.tolerance.delta = usual_shape;
  }
  constexpr int halvings = 12;
  constexpr double shrinkage = 0.99;
  const SuiteTolerance& of = task.tolerance;
  const double below = std::max({of.f.below, of.f.above, of.delta.below, of.width.below});
  const double most = std::max({of.f.below, of.f.above, of.delta.below, of.delta.above});
  if (below == 0 || most == 0) {
    return std::nullopt;
  }
  const auto holds = [&](double scale, bool brief) {
    const SuiteSpace space(task, frictions_of(damper), scale);
    SuiteSearch search(suite, task, space, {nullptr, {}, limits_of(task)}, watch, brief);
    return space.possible() && admissible(search.tried(damper).box.worst, limits_of(task));
  };
  double low = 0;
  double high = most_off / below;
  for (int i = 0; i < halvings && !watch.stopped(); ++i) {
    const double middle = (low + high) / 2;
    (holds(middle, true) ? low : high) = middle;
  }
  while (low > 0 && !watch.stopped() && !holds(low, false)) {
    low *= shrinkage;
  }
  return low > 0 ? std::optional(low * most) : std::nullopt;
}

}  // namespace

std::vector<Constraint> constraints_on(const RecordDesignRequest& task, const SuiteDamper& damper,
                                       double scale) {
  std::vector<Constraint> list;
  const auto add = [&](std::string_view name, std::string_view variable, double value,
                       const Spread& spread, const std::optional<double>& most) {
    if (most) {
      list.push_back(
          Constraint::compared(name, variable, "<=", value * (1 + scale * spread.above), *most));
    }
  };
  const auto& [f, delta, width, period] = task.tolerance;
  add("start", "f", damper.f, f, task.f_start);
  const double held = most_in_dead_zone(task, softest(task, damper.p));
  add("dead_zone", "f", damper.f, f, held < HUGE_VAL ? std::optional(held) : std::nullopt);
  add("start", "delta", damper.delta, delta, task.delta_start);
  add("f_max", "f", damper.f, f, task.f_max);
  add("delta_max", "delta", damper.delta, delta, task.delta_max);
  return list;
}

std::optional<ChosenBox> judged(const Suites& suite, RecordDesign& result, SuiteWatch& watch) {
  const RecordDesignRequest& task = result.request;
  const RecordDesignRequest open = without_bounds(task);
  const SuiteDamper damper = given_damper(task);
  const SuiteSpace space(open, frictions_of(damper));
  const TaskFigures own = suite.figures(damper);
  const bool keeps = keeps_bounds(task, damper) && admissible(own, limits_of(task));
  const auto tell = [&](const TaskFigures& worst) {
    result.nearest = {damper, worst};
    result.constraints = constraints_of(task, worst);
    std::ranges::copy(constraints_on(task, damper), std::back_inserter(result.constraints));
  };
  if (!task.parts.empty() && !keeps) {  // its box need not be tried
    tell(own);
    return std::nullopt;
  }
  SuiteSearch search(suite, open, space,
                     {minimised(task).value, task.objective_case, limits_of(task)}, watch);
  const VerifiedBox box = search.tried(damper, true);
  tell(box.box.worst);
  if (!settled(box.box.worst)) {
    return std::nullopt;
  }
  if (keeps) {
    result.largest_tolerance = largest_tolerance(suite, task, damper, watch);
  }
  return ChosenBox{box, 1};
}

std::optional<ChosenBox> best_part(const Suites& suite, RecordDesign& result, SuiteWatch& watch) {
  const RecordDesignRequest& task = result.request;
  std::vector<RatedPart> all;
  std::vector<std::optional<ChosenBox>> boxes;
  const auto box_of = [&](const Part& part) -> const std::optional<ChosenBox>& {
    const auto found = std::ranges::find_if(all, [&](const RatedPart& each) {
      return each.part.f == part.f && each.part.delta == part.delta;
    });
    return boxes[static_cast<std::size_t>(found - all.begin())];
  };
  constexpr std::int64_t about_a_part = 9'000;
  watch.expect(about_a_part * std::ssize(task.parts));
  for (const Part& part : task.parts) {
    if (watch.stopped() && !all.empty()) {
      break;
    }
    require_valid(part, task.p.high);
    RecordDesign one;
    one.request = task;
    one.request.f = Interval{part.f, part.f};
    one.request.delta = Interval{part.delta, part.delta};
    const auto box = judged(suite, one, watch);
    RatedPart rated{part, false, one.largest_tolerance, {}};
    std::ranges::copy_if(one.constraints, std::back_inserter(rated.violated),
                         [](const Constraint& now) { return !now.satisfied; });
    rated.admissible = box && rated.violated.empty();
    all.push_back(std::move(rated));
    boxes.push_back(box);
  }
  result.parts = best_first(all, [&](const RatedPart& rated) {
    return task.objective == SuiteObjective::robust ? -rated.tolerance.value_or(0)
                                                    : box_of(rated.part)->verified.box.rank.value;
  });
  const RatedPart& best = result.parts.front();
  if (!best.admissible) {
    return std::nullopt;
  }
  result.largest_tolerance = best.tolerance;
  return box_of(best.part);
}

}  // namespace stillpoint::design
