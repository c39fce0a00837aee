// SPDX-License-Identifier: MIT
#include "record/suite_maps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace stillpoint::design {

namespace {

/// Dampers of a map with one variable.
constexpr std::int64_t line_points = 1000;

}  // namespace

bool has_friction(const RecordDesignRequest& task, SuiteFrictions frictions) {
  return (frictions == SuiteFrictions::constant || task.delta->high > 0) &&
         (frictions == SuiteFrictions::point || task.f->high > 0 ||
          (frictions == SuiteFrictions::constant && task.delta->high == 0));
}

MappedSpace::MappedSpace(const Suites& suite, const RecordDesignRequest& task, SuiteFrictions which,
                         SuiteWatch& watch)
    : frictions(which),
      space(task, which),
      scan(suite, space, points_of_scan(task, space, line_points), task.threads, watch) {}

void SuiteMaps::expect() {
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

void SuiteMaps::add_missing() {
  for (const SuiteFrictions frictions : every_friction) {
    if (has_friction(task_, frictions) && SuiteSpace(task_, frictions).possible() &&
        of(frictions) == nullptr) {
      add(frictions);
    }
  }
}

MappedSpace* SuiteMaps::of(SuiteFrictions frictions) {
  const auto found = std::ranges::find(all_, frictions, &MappedSpace::frictions);
  return found == all_.end() ? nullptr : &*found;
}

bool SuiteMaps::are_hopeless(const SuiteGoal& goal) const {
  return std::ranges::count_if(every_friction,
                               [&](SuiteFrictions each) { return has_friction(task_, each); }) ==
             std::ssize(all_) &&
         std::ranges::none_of(all_,
                              [&](const MappedSpace& here) { return here.scan.may_have(goal); });
}

/// Each is to be better than those before, so the last is verified first.
std::optional<VerifiedBox> SuiteMaps::least(const SuiteGoal& goal) {
  struct Likely {
    SuiteSearch search;
    std::vector<BoxedDamper> dampers;
  };
  double bar = HUGE_VAL;
  std::deque<Likely> all;  // the last first
  for (MappedSpace& here : all_) {
    const bool brief = here.space.searched() > 2;
    Likely now{{suite_, task_, here.space, goal, watch_, brief}, {}};
    here.scan.look(goal, bar);
    now.dampers = now.search.likeliest(here.scan.map(), here.scan.grid(), bar);
    if (here.nearest && admissible(here.nearest->worst, goal.limits)) {
      const auto& [damper, worst, of_task] = *here.nearest;
      now.dampers.push_back({damper, worst, rank(worst, goal)});
      std::ranges::stable_sort(now.dampers, {}, &BoxedDamper::rank);
    }
    const auto first =
        std::ranges::find(now.dampers, 0.0, [](const BoxedDamper& each) { return each.rank.off; });
    if (first != now.dampers.end()) {
      bar = std::min(bar, first->rank.value);
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

}  // namespace stillpoint::design
