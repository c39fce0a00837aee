// SPDX-License-Identifier: MIT
#include "record/suite_help.hpp"

#include "record/suite_request.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

/// A limit that was relaxed is this much above the worst of the box that was found, so that a
/// search with it finds one as well.
constexpr double relaxed_by = 2e-3;

class SuiteHelp {
 public:
  SuiteHelp(const Suites& suite, RecordDesign& result, SuiteMaps& maps, const AlongF& along_f,
            SuiteWatch& watch)
      : suite_(suite),
        result_(result),
        task_(result.request),
        maps_(maps),
        along_f_(along_f),
        watch_(watch) {}

  /// The box that violates the limits least, and what would do.
  void tell(const SuiteGoal& goal) {
    std::optional<VerifiedBox> nearest;
    const SuiteSpace* space = nullptr;
    for (const MappedSpace& here : maps_.all()) {
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
                  along_f_.task && along_f_.task->moves(kind) ? std::nullopt : relaxed(c, kind)) {
            result_.mends.push_back({kind.field, *enough, true, task_.cases[c].name});
          }
        }
      }
    }
    if (along_f_.task) {
      constexpr double to_find = 5e-4;
      constexpr double more_to_find = 5e-3;  // than of one that was not verified
      const std::vector<Mend> known = along_f_.task->mends(along_f_.best ? more_to_find : to_find);
      result_.mends.insert(result_.mends.begin(), known.begin(), known.end());
      const auto tolerance = std::ranges::find(known, "tolerance", &Mend::field);
      if (tolerance != known.end()) {
        result_.largest_tolerance = tolerance->value;
      }
    } else {
      weaken();
    }
  }

 private:
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
    const std::optional<VerifiedBox> found = maps_.least(goal);
    return found && !watch_.stopped() ? 1 / (any * found->box.rank.value * (1 + relaxed_by)) : 0;
  }

  /// The least limit of that kind with which there is a damper; of the residual, one that does more
  /// than hold the mass.
  std::optional<double> relaxed(std::size_t in_case, const SuiteFigureKind& kind) {
    SuiteGoal goal{kind.value, in_case, limits_of(task_)};
    goal.limits[in_case].*kind.limit = std::nullopt;
    const bool rests = kind.limit == &SuiteLimits::residual;
    const auto found = rests ? least_of_resting(in_case, goal) : maps_.least(goal);
    if (!found || watch_.stopped()) {
      return std::nullopt;
    }
    const SuiteFigures& worst = found->box.worst[in_case];
    const double value = worst.*kind.value;
    const SuiteLimits& limits = task_.cases[in_case].limits;
    constexpr double measured = 1e-4;  // of the stroke: less is no residual that anybody allows
    if (rests && !(value > *limits.residual)) {
      return std::nullopt;  // it is something else that was not found
    }
    return kind.limit == &SuiteLimits::passages ? value + 1  // the last arrival rests
           : rests ? std::max(value * (1 + relaxed_by), measured * limits.peak.value_or(worst.peak))
                   : value * (1 + relaxed_by);
  }

  /// Where the mass may rest off centre more friction is of use, and of a hit less than holds it
  /// beyond its stroke.
  std::optional<VerifiedBox> least_of_resting(std::size_t in_case, const SuiteGoal& goal) {
    RecordDesignRequest resting = task_;
    SuiteLimits& limits = resting.cases[in_case].limits;
    limits.residual = limits.peak;
    const RecordDesignRequest open = with_open_friction(task_);
    if (open.f == task_.f) {
      resting.f = std::nullopt;
    }
    if (open.delta == task_.delta) {
      resting.delta = std::nullopt;
    }
    resting = completed(std::move(resting));
    if (const double moving = most_moving(task_.cases[in_case]); moving >= resting.f->low) {
      resting.f->high = std::min(resting.f->high, moving);
    }
    SuiteMaps maps(suite_, resting, watch_);
    maps.add_missing();
    return maps.least(goal);
  }

  /// The largest f of a damper of which none holds almost all of that load; of a hit any.
  [[nodiscard]] double most_moving(const LoadCase& load) const {
    constexpr double almost = 0.95;
    return load.v0 ? HUGE_VAL
                   : almost * peak_load(load, task_.p.low) / task_.breakaway /
                         (1 + task_.tolerance.f.above);
  }

  const Suites& suite_;
  RecordDesign& result_;
  const RecordDesignRequest& task_;
  SuiteMaps& maps_;
  const AlongF& along_f_;
  SuiteWatch& watch_;
};

}  // namespace

void tell_what_helps(const Suites& suite, RecordDesign& result, const SuiteGoal& goal,
                     SuiteMaps& maps, const AlongF& along_f, SuiteWatch& watch) {
  SuiteHelp(suite, result, maps, along_f, watch).tell(goal);
}

}  // namespace stillpoint::design
