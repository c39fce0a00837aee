// SPDX-License-Identifier: MIT

// Whether a box holds in many dampers that were not tried before, and the next one where it does
// not.

#include "record/suite_digits.hpp"
#include "record/suite_search.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>

namespace stillpoint::design {

namespace {

constexpr std::size_t most_learnt = 24;  ///< places where a verification found a limit broken
constexpr std::size_t learnt_at_once = 4;
constexpr std::size_t first_verified = 500;
constexpr int most_failures = 8;
constexpr std::size_t most_verified = 2;
/// A limit is tightened where it is exceeded by less than this part; what exceeds it by more jumps,
/// and no smaller limit mends that.
constexpr double most_tightened = 0.02;

}  // namespace

VerifiedBox SuiteSearch::tried(const SuiteDamper& damper) {
  std::vector<SuitePlace> places = worst_places_;
  std::ranges::copy(box_samples(space_, verifying_samples), std::back_inserter(places));
  VerifiedBox result{boxed(damper, {}), {}, 0};
  result.of.fill(damper);
  for (std::size_t begin = 0; begin < places.size();) {
    const std::size_t end = std::min(std::max(first_verified, 2 * begin), places.size());
    std::vector<SuiteDamper> dampers;
    for (std::size_t i = begin; i < end; ++i) {
      dampers.push_back(space_.off(damper, places[i]));
    }
    const std::vector<SuiteFigures> all = figures(dampers);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = 0; k < suite_figure_kinds.size(); ++k) {
        const auto member = suite_figure_kinds.at(k).value;
        if (all[i].*member > result.box.worst.*member) {
          result.of.at(k) = dampers[i];
        }
      }
      result.box.worst = worse(result.box.worst, all[i]);
    }
    result.samples = static_cast<std::int64_t>(end);
    // The samples that are worst, for the next box.
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto off = [&](std::size_t i) { return excess(all[i], limits_); };
    std::ranges::stable_sort(order, std::ranges::greater(), off);
    for (std::size_t k = 0; k < std::min(learnt_at_once, order.size()) && off(order[k]) > 0; ++k) {
      worst_places_.push_back(places[begin + order[k]]);
    }
    begin = end;
    if (!admissible(result.box.worst, limits_)) {
      break;
    }
  }
  result.box.rank = rank(result.box.worst, {goal_.figure, limits_});
  if (suite_.figures(damper).margin < least_suite_margin) {
    result.box.rank.off += least_suite_margin;
  }
  return result;
}

BoxedDamper SuiteSearch::rounded(const BoxedDamper& found) {
  if (!task_.printed || found.rank.off > 0) {
    return found;
  }
  const bool exact = space_.toleranced() == 0;
  const double costs_nothing = exact ? 1e-5 : 1e-3;
  constexpr int most = 12;
  BoxedDamper bar = found;
  bar.rank.value *= 1 + costs_nothing;
  for (int digits = exact ? 5 : 3; digits <= most; ++digits) {
    std::vector<SuiteDamper> near = neighbours_of_digits(task_, found.damper, digits);
    std::erase_if(near,
                  [&](const SuiteDamper& each) { return !space_.includes(space_.place(each)); });
    if (near.empty()) {
      continue;
    }
    const BoxedDamper now = best_of(near, bar);
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
    if (space_.includes(place) && suite_.figures(damper).margin >= least_suite_margin) {
      return {damper, found.worst, found.rank};
    }
  }
  return found;
}

void SuiteSearch::tighten(const SuiteFigures& worst) {
  for (const SuiteFigureKind& kind : suite_figure_kinds) {
    const std::optional<double>& given = limits_.*kind.limit;
    std::optional<double>& limit = goal_.limits.*kind.limit;
    const double part = given ? worst.*kind.value / *given : 0;
    if (part > 1 && part < 1 + most_tightened) {
      *limit /= part;
    }
  }
}

BoxedDamper SuiteSearch::mended(const BoxedDamper& failed, const SuiteFigures& worst) {
  samples_.insert(samples_.begin(),
                  worst_places_.end() -
                      static_cast<std::ptrdiff_t>(std::min(learnt_at_once, worst_places_.size())),
                  worst_places_.end());
  if (worst_places_.size() > most_learnt) {
    worst_places_.erase(worst_places_.begin(),
                        worst_places_.end() - static_cast<std::ptrdiff_t>(most_learnt));
  }
  tighten(worst);
  return polished(failed, first_step());
}

/// The likeliest is tried first, so that one which has to be mended waits for those that are as
/// good as what is left of it.
std::optional<VerifiedBox> SuiteSearch::verified(const std::vector<BoxedDamper>& candidates,
                                                 double bar) {
  struct Candidate {
    BoxedDamper box;
    SuiteLimits limits;
    int failures{0};
    std::optional<SuiteFigures> broken;  ///< the worst of a verification that failed
  };
  const SuiteLimits given = goal_.limits;
  std::vector<Candidate> left;
  left.reserve(candidates.size());
  for (const BoxedDamper& box : candidates) {
    left.push_back({box, given, 0, {}});
  }
  std::optional<VerifiedBox> best;
  std::size_t count = 0;
  const auto is_hopeless = [&](const Candidate& each) {
    return each.failures == most_failures || !admissible(each.box.worst, limits_) ||
           each.box.rank.value >= bar;
  };
  while (count < most_verified && !watch_.stopped()) {
    std::erase_if(left, is_hopeless);
    const auto next =
        std::ranges::min_element(left, {}, [](const Candidate& each) { return merit(each.box); });
    if (next == left.end()) {
      break;
    }
    goal_.limits = next->limits;
    if (next->broken) {
      next->box = mended(next->box, *next->broken);
      next->limits = goal_.limits;
      next->broken.reset();
      continue;
    }
    next->box = clear(rounded(next->box));
    const VerifiedBox box = tried(next->box.damper);
    if (watch_.stopped()) {
      break;
    }
    if (box.box.rank.off > 0) {
      next->box.rank = box.box.rank;
      next->broken = box.box.worst;
      ++next->failures;
      continue;
    }
    if (box.box.rank.value < bar) {
      best = box;
      bar = box.box.rank.value;
      ++count;
    }
    // Limits that were tightened may leave room: once more without, by the samples learnt since.
    if (next->failures > 1 && next->failures < most_failures) {
      goal_.limits = given;
      *next = {polished(box.box, first_step()), given, most_failures - 1, {}};
    } else {
      left.erase(next);
    }
  }
  goal_.limits = given;
  return best;
}

}  // namespace stillpoint::design
