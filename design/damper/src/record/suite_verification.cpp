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
constexpr int most_verifications = 8;
/// A limit is tightened by at most this part at once, for a residual may jump.
constexpr double most_tightened = 0.03;

}  // namespace

VerifiedBox SuiteSearch::tried(const SuiteDamper& damper) {
  std::vector<SuitePlace> places = worst_places_;
  std::ranges::copy(box_samples(space_, verifying_samples), std::back_inserter(places));
  VerifiedBox result{boxed(damper, {}), {}, 0};
  result.of.fill(damper);
  for (std::size_t begin = 0; begin < places.size();) {
    const std::size_t end = begin == 0 ? std::min(first_verified, places.size()) : places.size();
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
    if (given && worst.*kind.value > *given) {
      *limit *= std::max(*given / (worst.*kind.value), 1 - most_tightened);
    }
  }
}

std::optional<VerifiedBox> SuiteSearch::verified(BoxedDamper candidate) {
  const double step = first_step();
  const SuiteLimits before = goal_.limits;
  std::optional<VerifiedBox> result;
  for (int i = 0; i < most_verifications && !result && !watch_.stopped(); ++i) {
    candidate = clear(rounded(candidate));
    VerifiedBox box = tried(candidate.damper);
    if (watch_.stopped()) {
      break;
    }
    if (box.box.rank.off == 0) {
      result = box;
      break;
    }
    samples_.insert(samples_.begin(),
                    worst_places_.end() -
                        static_cast<std::ptrdiff_t>(std::min(learnt_at_once, worst_places_.size())),
                    worst_places_.end());
    if (worst_places_.size() > most_learnt) {
      worst_places_.erase(worst_places_.begin(),
                          worst_places_.end() - static_cast<std::ptrdiff_t>(most_learnt));
    }
    tighten(box.box.worst);
    candidate = polished(candidate, step);
    if (!admissible(candidate.worst, limits_)) {
      break;
    }
  }
  goal_.limits = before;
  return result;
}

}  // namespace stillpoint::design
