// SPDX-License-Identifier: MIT
#include "record/suite_task_search.hpp"

#include "record/suite_front.hpp"
#include "record/suite_help.hpp"
#include "record/suite_maps.hpp"
#include "record/suite_request.hpp"
#include "record/suite_tolerance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stillpoint::design {

namespace {

/// A notch that gains less than this part is left out.
constexpr double least_gain = 0.01;
/// Part of a value by which what is known along f is moved: by rounding alone.
constexpr double known_step = 1e-3;
/// Part of a value by which a box that grew is moved at first.
constexpr double grown_step = 0.0125;
/// Than the required size, of a box that grew beyond it and fails with it.
constexpr double hardly_smaller = 0.99;
/// The largest box of these first: it rules the others out.
constexpr std::array most_tolerant_first{SuiteFrictions::both, SuiteFrictions::point,
                                         SuiteFrictions::constant};

class TaskSearch {
 public:
  TaskSearch(const Suites& suite, RecordDesign& result, SuiteWatch& watch)
      : suite_(suite),
        result_(result),
        task_(result.request),
        watch_(watch),
        along_f_(task_),
        maps_(suite, task_, watch) {}

  std::optional<ChosenBox> within_tolerance() {
    const SuiteGoal goal{minimised(task_).value, task_.objective_case, limits_of(task_)};
    if (const auto known = best_along_f(goal)) {
      find_front(suite_, result_, maps_, watch_);
      return ChosenBox{*known, 1};
    }
    if (is_hopeless_along_f()) {
      tell_why_on_maps(goal);
      return std::nullopt;
    }
    std::optional<VerifiedBox> best;
    maps_.expect();
    for (const SuiteFrictions frictions : every_friction) {
      if (!has_friction(task_, frictions) || !SuiteSpace(task_, frictions).possible() ||
          watch_.stopped()) {
        continue;
      }
      MappedSpace& here = maps_.add(frictions);
      const double bar =
          !best ? HUGE_VAL
                : best->box.rank.value * (best->box.damper.delta == 0 ? 1 - least_gain : 1);
      here.scan.look(goal, bar);
      const BoxMap map = here.scan.map();
      count(here, map, goal);
      SuiteSearch search(suite_, task_, here.space, goal, watch_);
      const std::vector<BoxedDamper> list = search.likeliest(map, here.scan.grid(), bar);
      if (!list.empty()) {
        here.nearest = list.front();
      }
      if (auto now = search.verified(list, bar)) {
        best = now;
        watch_.verified({best->box.damper, best->box.worst});
      }
    }
    if (!best) {
      best = grown_to_tolerance(goal);
    }
    if (!best) {
      tell_what_helps(suite_, result_, goal, maps_, along_f_, watch_);
      return std::nullopt;
    }
    find_front(suite_, result_, maps_, watch_);
    return ChosenBox{*best, 1};
  }

  std::optional<ChosenBox> most_tolerant() {
    std::optional<LargestBox> best = largest_along_f();
    if (!best && !is_hopeless_along_f()) {
      maps_.expect();
      best = largest(HUGE_VAL);
    }
    constexpr double whole = 1 - 1e-9;
    if (!best && !task_.requires_tolerance) {
      return without_tolerance();
    }
    if (!best || (task_.requires_tolerance && best->scale < whole)) {
      const SuiteGoal goal{minimised(task_).value, task_.objective_case, limits_of(task_)};
      tell_why_on_maps(goal);
      return std::nullopt;
    }
    find_front(suite_, result_, maps_, watch_);
    return ChosenBox{best->verified, best->scale};
  }

 private:
  /// The best where it is known along f, unless its box fails.
  std::optional<VerifiedBox> best_along_f(const SuiteGoal& goal) {
    if (!along_f_.best) {
      return std::nullopt;
    }
    const SuiteSpace whole(task_, SuiteFrictions::both);
    const auto tried = [&](SuiteDamper damper) -> std::optional<VerifiedBox> {
      if (whole.possible() && whole.nearest(damper).f > damper.f) {
        damper.f = 0;  // so little is none
      }
      const SuiteSpace space(task_, frictions_of(damper));
      if (!space.possible()) {
        return std::nullopt;
      }
      SuiteSearch search(suite_, task_, space, goal, watch_);
      return search.verified({search.polished({space.nearest(damper), {}, {}}, known_step)});
    };
    std::optional<VerifiedBox> box = tried(along_f_.best->damper);
    if (!box) {
      for (const SuiteDamper& damper : along_f_.task->towards_room(along_f_.best->damper)) {
        box = box ? box : tried(damper);
      }
    }
    return box;
  }

  /// Of a hit also where the best leaves no room to verify it: between the strips that are known a
  /// map may miss the motions that fail.
  [[nodiscard]] bool is_hopeless_along_f() const {
    return along_f_.task && (!along_f_.best || along_f_.task->of_hit());
  }

  std::optional<LargestBox> largest_along_f() {
    auto best = along_f_.best
                    ? largest_box_about(suite_, task_, *along_f_.best, most_scale(), watch_)
                    : std::nullopt;
    if (best) {
      note(*best);
    }
    return best;
  }

  /// No part of a damper is off by more than `most_off` then.
  [[nodiscard]] double most_scale() const {
    const SuiteTolerance& of = task_.tolerance;
    return most_off /
           std::max({of.f.below, of.delta.below, of.width.below, of.period.below, of.f.above});
  }

  void note(const LargestBox& best) {
    const SuiteTolerance& of = task_.tolerance;
    watch_.verified({best.verified.box.damper, best.verified.box.worst});
    result_.largest_tolerance =
        best.scale * std::max({of.f.below, of.f.above, of.delta.below, of.delta.above});
  }

  void count(const MappedSpace& here, const BoxMap& map, const SuiteGoal& goal) {
    result_.search.scan->points += here.scan.computed();
    result_.search.scan->feasible += map.admissible(goal);
  }

  /// Of a task that asks for none: why there is no damper at all, or one that must be exact.
  std::optional<ChosenBox> without_tolerance() {
    RecordDesign exact = without_errors(task_);
    std::optional<ChosenBox> found = TaskSearch(suite_, exact, watch_).within_tolerance();
    result_ = std::move(exact);
    return found;
  }

  /// On the maps that there are, or looked for by itself.
  std::optional<LargestBox> largest(double most) {
    std::optional<LargestBox> best;
    if (std::isinf(most_scale())) {
      return best;
    }
    for (const SuiteFrictions frictions : most_tolerant_first) {
      if (!has_friction(task_, frictions) || watch_.stopped()) {
        continue;
      }
      const double bar =
          !best ? 0 : best->scale / (frictions == SuiteFrictions::constant ? 1 + least_gain : 1);
      const MappedSpace* here = maps_.of(frictions);
      auto now = largest_box(suite_, task_, frictions, {bar, std::min(most, most_scale())},
                             here == nullptr ? nullptr : &here->scan, watch_);
      if (now) {
        best = now;
        note(*best);
      }
    }
    return best;
  }

  /// A box that is so hard to find that only one which grows gets there; leaves the largest
  /// tolerance in the result if there is none.
  std::optional<VerifiedBox> grown_to_tolerance(const SuiteGoal& goal) {
    const std::optional<LargestBox> found =
        watch_.stopped() || is_hopeless_along_f() || maps_.are_hopeless(goal) ? std::nullopt
                                                                              : largest(HUGE_VAL);
    if (!found || found->scale < 1) {
      return std::nullopt;
    }
    const SuiteSpace space(task_, frictions_of(found->verified.box.damper));
    SuiteSearch search(suite_, task_, space, goal, watch_);
    std::optional<VerifiedBox> box =
        search.verified({search.polished(found->verified.box, grown_step), found->verified.box});
    result_.largest_tolerance.reset();
    if (!box) {
      largest(hardly_smaller);
    }
    return box;
  }

  void tell_why_on_maps(const SuiteGoal& goal) {
    maps_.add_missing();
    for (MappedSpace& here : maps_.all()) {
      here.scan.look(goal, HUGE_VAL);
    }
    tell_what_helps(suite_, result_, goal, maps_, along_f_, watch_);
  }

  const Suites& suite_;
  RecordDesign& result_;
  const RecordDesignRequest& task_;
  SuiteWatch& watch_;
  AlongF along_f_;
  SuiteMaps maps_;
};

}  // namespace

std::optional<ChosenBox> searched(const Suites& suite, RecordDesign& result, SuiteWatch& watch) {
  TaskSearch search(suite, result, watch);
  return result.request.objective == SuiteObjective::robust ? search.most_tolerant()
                                                            : search.within_tolerance();
}

}  // namespace stillpoint::design
