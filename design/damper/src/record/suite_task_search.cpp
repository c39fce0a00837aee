// SPDX-License-Identifier: MIT
#include "record/suite_task_search.hpp"

#include "record/suite_request.hpp"
#include "record/suite_scan.hpp"
#include "record/suite_tolerance.hpp"
#include "record/task_along_f.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <utility>

namespace stillpoint::design {

namespace {

/// A notch that gains less than this part is left out.
constexpr double least_gain = 0.01;
/// Part of a value by which what is known along f is moved: by rounding alone.
constexpr double known_step = 1e-3;
/// A limit that was relaxed is this much above the worst of the box that was found, so that a
/// search with it finds one as well.
constexpr double relaxed_by = 2e-3;
/// Dampers of a map with one variable.
constexpr std::int64_t line_points = 1000;
/// Part of a value by which a box that grew is moved at first.
constexpr double grown_step = 0.0125;
/// Than the required size, of a box that grew beyond it and fails with it.
constexpr double hardly_smaller = 0.99;
constexpr std::array every_friction{SuiteFrictions::constant, SuiteFrictions::point,
                                    SuiteFrictions::both};
/// The largest box of these first: it rules the others out.
constexpr std::array most_tolerant_first{SuiteFrictions::both, SuiteFrictions::point,
                                         SuiteFrictions::constant};

bool has_friction(const RecordDesignRequest& task, SuiteFrictions frictions) {
  return (frictions == SuiteFrictions::constant || task.delta->high > 0) &&
         (frictions == SuiteFrictions::point || task.f->high > 0 ||
          (frictions == SuiteFrictions::constant && task.delta->high == 0));
}

/// A space with the map of its boxes.
struct Mapped {
  Mapped(const Suites& suite, const RecordDesignRequest& task, SuiteFrictions which,
         SuiteWatch& watch)
      : frictions(which),
        space(task, which),
        scan(suite, space, points_of_scan(task, space, line_points), task.threads, watch) {}

  SuiteFrictions frictions;
  SuiteSpace space;
  SuiteScan scan;
  std::optional<BoxedDamper> nearest{};  ///< to the limits
};

class TaskSearch {
 public:
  TaskSearch(const Suites& suite, RecordDesign& result, SuiteWatch& watch)
      : suite_(suite),
        result_(result),
        task_(result.request),
        watch_(watch),
        along_f_(TaskAlongF::of(task_)),
        known_(along_f_ ? along_f_->best() : std::nullopt) {}

  std::optional<ChosenBox> within_tolerance() {
    const SuiteGoal goal{minimised(task_).value, task_.objective_case, limits_of(task_)};
    if (const auto known = best_along_f(goal)) {
      trade_off();
      return ChosenBox{*known, 1};
    }
    if (is_hopeless_along_f()) {
      tell_why_on_maps(goal);
      return std::nullopt;
    }
    std::optional<VerifiedBox> best;
    expect();
    for (const SuiteFrictions frictions : every_friction) {
      if (!has_friction(task_, frictions) || !SuiteSpace(task_, frictions).possible() ||
          watch_.stopped()) {
        continue;
      }
      Mapped& here = maps_.emplace_back(suite_, task_, frictions, watch_);
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
      tell_why(goal);
      return std::nullopt;
    }
    trade_off();
    return ChosenBox{*best, 1};
  }

  std::optional<ChosenBox> most_tolerant() {
    std::optional<LargestBox> best = largest_along_f();
    if (!best && !is_hopeless_along_f()) {
      expect();
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
    trade_off();
    return ChosenBox{best->verified, best->scale};
  }

 private:
  /// The best where it is known along f, unless its box fails.
  std::optional<VerifiedBox> best_along_f(const SuiteGoal& goal) {
    if (!known_) {
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
    std::optional<VerifiedBox> box = tried(known_->damper);
    if (!box) {
      for (const SuiteDamper& damper : along_f_->towards_room(known_->damper)) {
        box = box ? box : tried(damper);
      }
    }
    return box;
  }

  /// Of a hit also where the best leaves no room to verify it: between the strips that are known a
  /// map may miss the motions that fail.
  [[nodiscard]] bool is_hopeless_along_f() const {
    return along_f_ && (!known_ || along_f_->of_hit());
  }

  std::optional<LargestBox> largest_along_f() {
    auto best =
        known_ ? largest_box_about(suite_, task_, *known_, most_scale(), watch_) : std::nullopt;
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

  /// About what a map, candidates and verifications take.
  void expect() {
    constexpr std::int64_t about_a_line = 5'000;
    constexpr std::int64_t about_a_map = 12'000;
    for (const SuiteFrictions frictions : every_friction) {
      const SuiteSpace space(task_, frictions);
      if (has_friction(task_, frictions) && space.possible()) {
        watch_.expect(points_of_scan(task_, space, line_points) +
                      (space.searched() > 1 ? about_a_map : about_a_line));
      }
    }
  }

  void count(const Mapped& here, const BoxMap& map, const SuiteGoal& goal) {
    result_.search.scan->points += here.scan.computed();
    result_.search.scan->feasible += map.admissible(goal);
  }

  [[nodiscard]] RecordDesign without_errors() const {
    RecordDesign exact;
    exact.request = task_;
    exact.request.tolerance = {{}, {}, {}, {}};
    return exact;
  }

  /// Of a task that asks for none: why there is no damper at all, or one that must be exact.
  std::optional<ChosenBox> without_tolerance() {
    RecordDesign exact = without_errors();
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
      const auto here = std::ranges::find(maps_, frictions, &Mapped::frictions);
      auto now = largest_box(suite_, task_, frictions, {bar, std::min(most, most_scale())},
                             here == maps_.end() ? nullptr : &here->scan, watch_);
      if (now) {
        best = now;
        note(*best);
      }
    }
    return best;
  }

  /// Whether no damper at all is near the limits.
  [[nodiscard]] bool is_hopeless(const SuiteGoal& goal) const {
    return std::ranges::count_if(every_friction,
                                 [&](SuiteFrictions each) { return has_friction(task_, each); }) ==
               std::ssize(maps_) &&
           std::ranges::none_of(maps_,
                                [&](const Mapped& here) { return here.scan.may_have(goal); });
  }

  /// A box that is so hard to find that only one which grows gets there; leaves the largest
  /// tolerance in the result if there is none.
  std::optional<VerifiedBox> grown_to_tolerance(const SuiteGoal& goal) {
    const std::optional<LargestBox> found =
        watch_.stopped() || is_hopeless_along_f() || is_hopeless(goal) ? std::nullopt
                                                                       : largest(HUGE_VAL);
    if (!found || found->scale < 1) {
      return std::nullopt;
    }
    const SuiteSpace space(task_, frictions_of(found->verified.box.damper));
    SuiteSearch search(suite_, task_, space, goal, watch_);
    std::optional<VerifiedBox> box =
        search.verified({search.polished(found->verified.box, grown_step), found->verified.box});
    if (box) {
      result_.largest_tolerance.reset();
    } else {
      result_.largest_tolerance.reset();
      largest(hardly_smaller);
    }
    return box;
  }

  void tell_why_on_maps(const SuiteGoal& goal) {
    map_all();
    for (Mapped& here : maps_) {
      here.scan.look(goal, HUGE_VAL);
    }
    tell_why(goal);
  }

  /// The box that violates the limits least, and each limit that would do.
  void tell_why(const SuiteGoal& goal) {
    std::optional<VerifiedBox> nearest;
    const SuiteSpace* space = nullptr;
    for (const Mapped& here : maps_) {
      SuiteSearch search(suite_, task_, here.space, goal, watch_);
      const std::optional<SuiteDamper> damper =
          here.nearest ? here.nearest->damper : here.scan.nearest(goal);
      if (damper) {
        const VerifiedBox box = search.tried(*damper);
        if (!nearest || box.box.rank < nearest->box.rank) {
          nearest = box;
          space = &here.space;
        }
      }
    }
    if (!nearest) {
      result_.nearest.figures.assign(task_.cases.size(), unsettled);
      return;
    }
    SuiteSearch whole(suite_, task_, *space, goal, watch_);
    nearest = whole.tried(nearest->box.damper, true);
    result_.nearest = {nearest->box.damper, nearest->box.worst};
    result_.constraints = constraints_of(task_, nearest->box.worst);
    auto constraint = result_.constraints.begin();
    for (std::size_t c = 0; c < task_.cases.size(); ++c) {
      for (std::size_t k = 0; k < suite_figure_kinds.size(); ++k) {
        const SuiteFigureKind& kind = suite_figure_kinds.at(k);
        if (task_.cases[c].limits.*kind.limit) {
          const Suite& of_case = suite_.cases()[c];
          const CaseMotion& motion =
              of_case.motions()[of_case.worst_motion(nearest->of[c].at(k), kind)];
          constraint++->motion = {motion.name, motion.scale};
          if (const auto enough =
                  along_f_ && along_f_->moves(kind) ? std::nullopt : relaxed(c, kind)) {
            result_.mends.push_back({kind.field, *enough, true, task_.cases[c].name});
          }
        }
      }
    }
    if (along_f_) {
      constexpr double to_find = 5e-4;
      constexpr double more_to_find = 5e-3;  // than of one that was not verified
      const std::vector<Mend> known = along_f_->mends(known_ ? more_to_find : to_find);
      result_.mends.insert(result_.mends.begin(), known.begin(), known.end());
      const auto tolerance = std::ranges::find(known, "tolerance", &Mend::field);
      if (tolerance != known.end()) {
        result_.largest_tolerance = tolerance->value;
      }
    } else {
      weaken();
    }
  }

  /// The largest part of the load of a single case with which there is a damper: the figures of any
  /// damper under it, and the damper itself, are those of the whole load times that part. If only
  /// the stroke grows with a hit, the spring helps as well: as much stiffer it turns the mass
  /// there.
  void weaken() {
    const LoadCase& only = task_.cases.front();
    const bool scales = task_.cases.size() == 1 && only.weakest == 1 && !task_.hold &&
                        !task_.width && !task_.f_max && !task_.delta_max && task_.f->low == 0 &&
                        task_.delta->low == 0 && !only.limits.stop_time &&
                        only.limits.passages.value_or(0) == 0;
    std::vector<const SuiteFigureKind*> limited;
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      if ((only.limits.*kind.limit).value_or(0) > 0) {
        limited.push_back(&kind);
      }
    }
    if (!scales || limited.empty()) {
      return;
    }
    const auto in_the_way = std::ranges::find(result_.mends, limited.front()->field, &Mend::field);
    const double part = limited.size() > 1 ? most_of_load()
                        : in_the_way == result_.mends.end()
                            ? 0
                            : *(only.limits.*limited.front()->limit) / in_the_way->value;
    if (part == 0) {
      return;
    }
    const bool of_stroke = limited.front()->limit == &SuiteLimits::peak && limited.size() == 1;
    if (only.v0 && of_stroke && task_.p.low == task_.p.high) {
      result_.mends.insert(result_.mends.begin(), {"p", task_.p.low / part, true});
    }
    if (only.of_records()) {
      result_.mends.push_back({"scale", part});
    } else {
      const double load = only.v0 ? *only.v0 : peak_load(*only.pulse);
      result_.mends.insert(result_.mends.begin(), {only.v0 ? "v0" : "k", part * load});
    }
  }

  /// Within several limits at once: the least part of them that some damper uses, which may be more
  /// than all. 0 if that is not found.
  double most_of_load() {
    constexpr double any = 1e6;  // so much of the load passes for no limit
    SuiteGoal goal{nullptr, {}, limits_of(task_)};
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      if (std::optional<double>& limit = goal.limits.front().*kind.limit) {
        *limit *= any;
      }
    }
    const std::optional<VerifiedBox> found = least(goal, true);
    return found && !watch_.stopped() ? 1 / (any * found->box.rank.value * (1 + relaxed_by)) : 0;
  }

  /// The least limit of that kind with which there is a damper; of the residual, one that does more
  /// than hold the mass.
  std::optional<double> relaxed(std::size_t in_case, const SuiteFigureKind& kind) {
    SuiteGoal goal{kind.value, in_case, limits_of(task_)};
    goal.limits[in_case].*kind.limit = std::nullopt;
    std::optional<VerifiedBox> found = least(goal);
    if (found && kind.limit == &SuiteLimits::residual) {
      found = clamps(found->box.damper) ? std::nullopt : unless_held(*found, in_case, goal);
    }
    if (!found || watch_.stopped()) {
      return std::nullopt;
    }
    const SuiteFigures& worst = found->box.worst[in_case];
    const double value = worst.*kind.value;
    constexpr double measured = 1e-4;  // of the stroke: less is no residual that anybody allows
    return kind.limit == &SuiteLimits::passages ? value + 1  // the last arrival rests
           : kind.limit == &SuiteLimits::residual
               ? std::max(value * (1 + relaxed_by), measured * worst.peak)
               : value * (1 + relaxed_by);
  }

  /// Where the mass of a hit may rest off centre, friction must not hold it beyond its stroke: what
  /// was found, or looked for again if that does.
  std::optional<VerifiedBox> unless_held(const VerifiedBox& found, std::size_t in_case,
                                         const SuiteGoal& goal) {
    RecordDesign resting;
    resting.request = task_;
    SuiteLimits& limits = resting.request.cases[in_case].limits;
    limits.residual = limits.peak;
    const SuiteDamper& damper = found.box.damper;
    if (damper.f * (1 + task_.tolerance.f.above) <=
        most_in_dead_zone(resting.request, softest(task_, damper.p))) {
      return found;
    }
    TaskSearch search(suite_, resting, watch_);
    search.map_all();
    return search.least(goal, true);
  }

  /// Whether friction alone holds almost all of every load.
  [[nodiscard]] bool clamps(const SuiteDamper& damper) const {
    constexpr double almost = 0.95;
    return std::ranges::all_of(task_.cases, [&](const LoadCase& each) {
      return !each.v0 && damper.f * task_.breakaway >= almost * peak_load(each, damper.p);
    });
  }

  /// Those of frictions that have none.
  void map_all() {
    for (const SuiteFrictions frictions : every_friction) {
      if (has_friction(task_, frictions) && SuiteSpace(task_, frictions).possible() &&
          std::ranges::find(maps_, frictions, &Mapped::frictions) == maps_.end()) {
        maps_.emplace_back(suite_, task_, frictions, watch_);
      }
    }
  }

  /// The front of stroke and acceleration, from the least stroke to the least acceleration: of
  /// dampers without an error where only the largest box is asked for.
  void trade_off() {
    if (task_.trade_offs == 0) {
      return;
    }
    if (task_.objective == SuiteObjective::robust && !task_.requires_tolerance &&
        !task_.tolerance.exact() && std::ranges::none_of(task_.cases, &LoadCase::of_records)) {
      RecordDesign exact = without_errors();
      TaskSearch(suite_, exact, watch_).trade_off();
      result_.trade_off = std::move(exact.trade_off);
      return;
    }
    map_all();
    const auto gentlest = [&](double stroke) {
      SuiteGoal goal{&SuiteFigures::acceleration, {}, limits_of(task_)};
      for (SuiteLimits& limits : goal.limits) {
        limits.peak = std::min(limits.peak.value_or(HUGE_VAL), stroke);
      }
      return least(goal, true);
    };
    const auto end = gentlest(HUGE_VAL);
    const auto begin = least({&SuiteFigures::peak, {}, limits_of(task_)}, true);
    if (!begin || !end) {
      return;
    }
    const double low = design::largest(begin->box.worst).peak;
    const double high = design::largest(end->box.worst).peak;
    std::vector<SuitePoint> all{{begin->box.damper, begin->box.worst},
                                {end->box.damper, end->box.worst}};
    const auto last = static_cast<double>(task_.trade_offs - 1);
    for (std::int64_t i = 1; i + 1 < task_.trade_offs && !watch_.stopped(); ++i) {
      if (const auto between = gentlest(std::lerp(low, high, static_cast<double>(i) / last))) {
        all.push_back({between->box.damper, between->box.worst});
      }
    }
    std::ranges::stable_sort(
        all, {}, [](const SuitePoint& point) { return design::largest(point.figures).peak; });
    for (SuitePoint& point : all) {  // no other has less of both
      std::vector<SuitePoint>& front = result_.trade_off;
      if (front.empty() || design::largest(point.figures).acceleration <
                               design::largest(front.back().figures).acceleration) {
        front.push_back(std::move(point));
      }
    }
  }

  /// The best of all frictions, looked for briefly; unless `anew` the nearest, where it violates no
  /// limit of the goal. Each is to be better than those before, so the last is verified first.
  std::optional<VerifiedBox> least(const SuiteGoal& goal, bool anew = false) {
    struct Likely {
      SuiteSearch search;
      std::vector<BoxedDamper> dampers;
    };
    double bar = HUGE_VAL;
    std::deque<Likely> all;  // the last first
    for (Mapped& here : maps_) {
      const bool brief = here.space.searched() > 2;
      Likely now{{suite_, task_, here.space, goal, watch_, brief}, {}};
      if (!anew && here.nearest && admissible(here.nearest->worst, goal.limits)) {
        now.dampers = {
            {here.nearest->damper, here.nearest->worst, rank(here.nearest->worst, goal)}};
      } else {
        here.scan.look(goal, bar);
        now.dampers = now.search.likeliest(here.scan.map(), here.scan.grid(), bar);
      }
      if (!now.dampers.empty() && now.dampers.front().rank.off == 0) {
        bar = std::min(bar, now.dampers.front().rank.value);
        all.push_front(std::move(now));
      }
    }
    bar = HUGE_VAL;
    std::optional<VerifiedBox> best;
    for (Likely& each : all) {
      if (auto found = each.search.verified(each.dampers, bar)) {
        best = std::move(found);
        bar = goal.value(best->box.worst);
      }
    }
    return best;
  }

  const Suites& suite_;
  RecordDesign& result_;
  const RecordDesignRequest& task_;
  SuiteWatch& watch_;
  std::optional<TaskAlongF> along_f_;  // where this task is one
  std::optional<DamperAlongF> known_;  // its best
  std::deque<Mapped> maps_;            // which refer to their own members
};

}  // namespace

std::vector<Constraint> constraints_of(const RecordDesignRequest& task, const TaskFigures& worst) {
  std::vector<Constraint> list;
  for (std::size_t c = 0; c < task.cases.size(); ++c) {
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      if (const std::optional<double>& limit = task.cases[c].limits.*kind.limit) {
        Constraint& now = list.emplace_back(Constraint::compared(
            kind.constraint, kind.variable, "<=", worst[c].*kind.value, *limit));
        now.in_case = task.cases[c].name;
        now.known = worst[c].settled;
        now.satisfied = now.satisfied && worst[c].settled;
      }
    }
  }
  return list;
}

std::optional<ChosenBox> searched(const Suites& suite, RecordDesign& result, SuiteWatch& watch) {
  TaskSearch search(suite, result, watch);
  return result.request.objective == SuiteObjective::robust ? search.most_tolerant()
                                                            : search.within_tolerance();
}

}  // namespace stillpoint::design
