// SPDX-License-Identifier: MIT

// Whether a box holds in many dampers that were not tried before, and the next one where it does
// not.

#include "record/suite_digits.hpp"
#include "record/suite_search.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace stillpoint::design {

namespace {

/// Places of a box where its verification found a limit broken.
constexpr std::size_t learnt_at_once = 4;
constexpr std::size_t first_verified = 500;
constexpr int most_failures = 8;
constexpr std::size_t most_verified = 2;
/// Of each limit, after each failure: what lies on a limit breaks it between the samples.
constexpr double reserve = 5e-4;
/// A box that is not better by this part than one that holds is not tried.
constexpr double worth_verifying = 1e-3;

std::vector<SuiteLimits> tightened(std::vector<SuiteLimits> limits, double part) {
  for (SuiteLimits& of_case : limits) {
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      if (std::optional<double>& limit = of_case.*kind.limit) {
        *limit *= 1 - part;
      }
    }
  }
  return limits;
}

}  // namespace

VerifiedBox SuiteSearch::tried(const SuiteDamper& damper, bool whole) {
  const std::vector<SuitePlace> places =
      box_samples(space_, brief_ ? brief_samples : verifying_samples);
  VerifiedBox result{boxed(damper, {}), {}, 0};
  result.of.resize(goal_.limits.size());
  for (WorstDampers& of_case : result.of) {
    of_case.fill(damper);
  }
  for (std::size_t begin = 0; begin < places.size();) {
    const std::size_t end = std::min(std::max(first_verified, 2 * begin), places.size());
    std::vector<SuiteDamper> dampers;
    for (std::size_t i = begin; i < end; ++i) {
      dampers.push_back(space_.off(damper, places[i]));
    }
    const std::vector<TaskFigures> all = figures(dampers);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const TaskFigures before = std::exchange(result.box.worst, worse(result.box.worst, all[i]));
      for (std::size_t c = 0; c < result.of.size(); ++c) {
        for (std::size_t k = 0; k < suite_figure_kinds.size(); ++k) {
          const auto member = suite_figure_kinds.at(k).value;
          if (all[i][c].*member > (before.empty() ? 0 : before[c].*member)) {
            result.of[c].at(k) = dampers[i];
          }
        }
      }
    }
    result.samples = static_cast<std::int64_t>(end);
    if (!whole && !admissible(result.box.worst, goal_.limits)) {
      learn(std::span(places).subspan(begin, end - begin), all);
      break;
    }
    begin = end;
  }
  result.box.rank = rank(result.box.worst, goal_);
  if (largest(suite_.figures(damper)).margin < least_suite_margin) {
    result.box.rank.off += least_suite_margin;
  }
  return result;
}

/// The places that are worst come first in every further box.
void SuiteSearch::learn(std::span<const SuitePlace> places, const std::vector<TaskFigures>& all) {
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto off = [&](std::size_t i) { return excess(all[i], goal_.limits); };
  std::ranges::stable_sort(order, std::ranges::greater(), off);
  order.resize(std::min(learnt_at_once, order.size()));
  std::ranges::reverse(order);
  for (const std::size_t i : order) {
    if (off(i) > 0) {
      samples_.insert(samples_.begin(), places[i]);
    }
  }
}

BoxedDamper SuiteSearch::rounded(const BoxedDamper& found, int most) {
  if (!task_.printed || found.rank.off > 0) {
    return found;
  }
  const bool exact = space_.toleranced() == 0;
  const double costs_nothing = exact ? 1e-5 : 1e-3;
  BoxedDamper bar = found;
  bar.rank.value *= 1 + costs_nothing;
  for (int digits = exact ? 5 : 3; digits <= most; ++digits) {
    std::vector<SuiteDamper> near = neighbours_of_digits(task_, found.damper, digits);
    std::erase_if(near,
                  [&](const SuiteDamper& each) { return !space_.includes(space_.place(each)); });
    if (near.empty()) {
      continue;
    }
    BoxedDamper now = best_of(near, bar);
    if (now.rank < bar.rank) {
      return now;
    }
  }
  return found;
}

/// Beside a decision that is so close that neither the check nor a real damper could tell it.
BoxedDamper SuiteSearch::clear(const BoxedDamper& found) const {
  for (const double part : {0.0, -1e-4, 1e-4, -3e-4, 3e-4, -1e-3, 1e-3}) {
    SuitePlace place = space_.place(found.damper);
    for (std::size_t i = 0; i < space_.size(); ++i) {
      place.at(i) += space_.axes()[i].searched() ? part : 0;
    }
    const SuiteDamper damper = part == 0 ? found.damper : space_.at(place);
    if (space_.includes(place) && largest(suite_.figures(damper)).margin >= least_suite_margin) {
      return {damper, found.worst, found.rank};
    }
  }
  return found;
}

/// The likeliest is tried first, so that one which has to be mended waits for those that are as
/// good as what is left of it.
std::optional<VerifiedBox> SuiteSearch::verified(const std::vector<BoxedDamper>& candidates,
                                                 double bar) {
  struct Candidate {
    BoxedDamper box;
    int failures{0};
    bool worse{false};  ///< in its last verification than by its samples
  };
  std::vector<Candidate> left;
  left.reserve(candidates.size());
  for (const BoxedDamper& box : candidates) {
    left.push_back({box});
  }
  std::optional<VerifiedBox> best;
  std::size_t count = 0;
  const auto is_hopeless = [&](const Candidate& each) {
    return each.failures == most_failures || !admissible(each.box.worst, goal_.limits) ||
           each.box.rank.value >= (best ? 1 - worth_verifying : 1) * bar;
  };
  while (count < most_verified && !watch_.stopped()) {
    std::erase_if(left, is_hopeless);
    const auto next =
        std::ranges::min_element(left, {}, [](const Candidate& each) { return merit(each.box); });
    if (next == left.end()) {
      break;
    }
    if (next->worse) {
      const std::vector<SuiteLimits> given = goal_.limits;
      goal_.limits = tightened(given, next->failures * reserve);
      next->box = polished(next->box, first_step(), false, bar);
      goal_.limits = given;
      next->box.rank = rank(next->box.worst, goal_);
      next->worse = false;
      continue;
    }
    next->box = ready(next->box);
    const VerifiedBox box = tried(next->box.damper);
    if (watch_.stopped()) {
      break;
    }
    const bool holds = box.box.rank.off == 0;
    if (holds && box.box.rank.value < bar) {
      best = box;
      bar = box.box.rank.value;
    }
    if (holds && box.box.rank.value <= (1 + worth_verifying) * next->box.rank.value) {
      ++count;
      left.erase(next);
      continue;
    }
    next->box.rank.off = box.box.rank.off;
    next->worse = true;
    ++next->failures;
  }
  return best;
}

}  // namespace stillpoint::design
