// SPDX-License-Identifier: MIT
#include "record/suite_search.hpp"

#include "record/suite_digits.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr std::size_t usual_samples = 48;
/// After so many, boxes that a sample rules out are dropped: those that were worst last rule out
/// most.
constexpr std::array<std::size_t, 3> sample_stages{2, 8, SIZE_MAX};
constexpr std::size_t most_learnt = 24;  ///< places where a verification found a limit broken
constexpr std::size_t learnt_at_once = 4;
constexpr std::size_t first_verified = 500;
constexpr int most_verifications = 8;
/// A limit is tightened by at most this part at once, for a residual may jump.
constexpr double most_tightened = 0.03;
constexpr double last_step = 4e-4;  ///< of a value, relative
constexpr int most_moves = 6;       ///< at each step
constexpr std::size_t most_verified = 2;
/// A candidate of the map that is this much worse than the bar will not get below it.
constexpr double hopeless = 1.1;
/// The same of one that was refined twice.
constexpr double unlikely = 1.02;

/// Steps to a box, and to each side of a candidate, by the number of axes.
constexpr std::array<std::int64_t, most_axes + 1> most_windows{1, 256, 16, 8, 4};
constexpr std::array<std::int64_t, most_axes + 1> reaches{1, 6, 3, 2, 1};
constexpr std::array<std::size_t, most_axes + 1> most_refined{1, 2, 2, 3, 3};
constexpr std::array<std::size_t, most_axes + 1> candidate_counts{1, 4, 6, 12, 12};

}  // namespace

SuiteSearch::SuiteSearch(const Suite& suite, const RecordDesignRequest& task,
                         const SuiteSpace& space, const SuiteGoal& goal, SuiteWatch& watch)
    : suite_(suite),
      task_(task),
      space_(space),
      goal_(goal),
      limits_(goal.limits),
      watch_(watch),
      samples_(box_samples(space, usual_samples)) {}

std::vector<SuiteFigures> SuiteSearch::figures(const std::vector<SuiteDamper>& dampers) {
  if (dampers.empty()) {
    return {};
  }
  std::vector<SuiteFigures> list = suite_.figures(dampers, task_.threads);
  watch_.evaluated(std::ssize(dampers));
  return list;
}

/// The box of a damper by the samples, which are sorted by how bad they are in it.
BoxedDamper SuiteSearch::sampled(const SuiteDamper& damper) {
  std::vector<SuiteDamper> dampers;
  dampers.reserve(samples_.size());
  for (const SuitePlace& unit : samples_) {
    dampers.push_back(space_.off(damper, unit));
  }
  const std::vector<SuiteFigures> all = figures(dampers);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [&](std::size_t i) { return rank(all[i], goal_); });
  std::vector<SuitePlace> sorted;
  SuiteFigures worst;
  for (const std::size_t i : order) {
    sorted.push_back(samples_[i]);
    worst = worse(worst, all[i]);
  }
  samples_ = std::move(sorted);
  return boxed(damper, worst);
}

std::vector<SuiteDamper> SuiteSearch::around(const SuiteDamper& damper, double step) const {
  const SuitePlace here = space_.place(damper);
  std::vector<SuitePlace> places{here};
  for (std::size_t i = 0; i < space_.size(); ++i) {
    if (space_.axes()[i].searched()) {
      const std::size_t count = places.size();
      for (std::size_t k = 0; k < count; ++k) {
        for (const double by : {-step, step}) {
          SuitePlace place = places[k];
          place.at(i) =
              std::clamp(place.at(i) + by, space_.axes()[i].low(), space_.axes()[i].high());
          places.push_back(place);
        }
      }
    }
  }
  std::vector<SuiteDamper> list;
  for (std::size_t k = 1; k < places.size(); ++k) {
    list.push_back(space_.at(places[k]));
  }
  return list;
}

/// The best of them if it is better than `bar`, else that. A sample that is worse rules a box out.
BoxedDamper SuiteSearch::best_of(const std::vector<SuiteDamper>& dampers, const BoxedDamper& bar) {
  std::vector<BoxedDamper> left;
  left.reserve(dampers.size());
  for (const SuiteDamper& damper : dampers) {
    left.push_back(boxed(damper, {}));
  }
  std::size_t begin = 0;
  for (const std::size_t stage : sample_stages) {
    const std::size_t end = std::min(stage, samples_.size());
    std::vector<SuiteDamper> tries;
    for (const BoxedDamper& each : left) {
      for (std::size_t i = begin; i < end; ++i) {
        tries.push_back(space_.off(each.damper, samples_[i]));
      }
    }
    const std::vector<SuiteFigures> all = figures(tries);
    std::size_t next = 0;
    for (BoxedDamper& each : left) {
      for (std::size_t i = begin; i < end; ++i) {
        each.worst = worse(each.worst, all[next++]);
      }
      each.rank = rank(each.worst, goal_);
    }
    std::erase_if(left, [&](const BoxedDamper& each) { return !(each.rank < bar.rank); });
    begin = end;
  }
  return left.empty() ? bar : *std::ranges::min_element(left, {}, &BoxedDamper::rank);
}

/// Half of that of the finest map.
double SuiteSearch::first_step() const {
  double step = 4 * last_step;
  for (const SuiteAxis& axis : space_.axes()) {
    if (axis.searched()) {
      step = std::max(step, (axis.down() + axis.up()) /
                                static_cast<double>(2 * most_windows.at(space_.size())));
    }
  }
  return step;
}

BoxedDamper SuiteSearch::polished(const BoxedDamper& from, double step, bool enough) {
  constexpr double coarse = 4;  // is enough where only the limits matter
  BoxedDamper best = sampled(from.damper);
  for (; step > (enough ? coarse : 1) * last_step && !(enough && best.rank.off == 0); step /= 2) {
    for (int i = 0; i < most_moves && !watch_.stopped(); ++i) {
      const BoxedDamper now = best_of(around(best.damper, step), best);
      if (!(now.rank < best.rank)) {
        break;
      }
      best = sampled(now.damper);
    }
  }
  return best;
}

BoxedDamper SuiteSearch::refined(BoxedDamper candidate, SuiteGrid& grid, int levels) {
  const std::size_t axes = space_.size();
  const std::int64_t most = most_windows.at(axes);
  const auto is_finest = [&](std::size_t i) {
    const GridSide& side = grid.at(i);
    const SuiteAxis& axis = space_.axes()[i];
    return !axis.searched() ||
           (axis.toleranced() && axis.down() + axis.up() > last_step ? 2 * side.window > most
                                                                     : side.step <= last_step);
  };
  for (int level = 0; level < levels && !watch_.stopped(); ++level) {
    bool finest = true;
    for (std::size_t i = 0; i < axes; ++i) {
      finest = finest && is_finest(i);
    }
    if (finest) {
      break;
    }
    grid = finer(space_, grid, most);
    const SuiteGrid patch = grid_about(space_, grid, candidate.damper, reaches.at(axes));
    const BoxMap map(space_, patch, grid_figures(suite_, space_, patch, task_.threads, watch_));
    const std::vector<BoxedDamper> best = map.best(goal_, 1);
    if (!best.empty()) {
      candidate = best.front();
    }
  }
  return candidate;
}

std::vector<BoxedDamper> SuiteSearch::all_refined(std::vector<BoxedDamper> found, SuiteGrid grid,
                                                  double bar) {
  constexpr int first_levels = 2;
  constexpr int most_levels = 64;
  SuiteGrid fine = grid;
  for (BoxedDamper& each : found) {
    fine = grid;
    each = refined(each, fine, first_levels);
  }
  std::ranges::stable_sort(found, {}, &BoxedDamper::rank);
  std::erase_if(found, [&](const BoxedDamper& each) { return each.rank.value > unlikely * bar; });
  found.resize(std::min(found.size(), most_refined.at(space_.size())));
  for (BoxedDamper& each : found) {
    grid = fine;
    each = polished(refined(each, grid, most_levels), first_step());
  }
  std::ranges::stable_sort(found, {}, &BoxedDamper::rank);
  return found;
}

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
    if (candidate.rank.off > 0) {
      break;
    }
  }
  goal_.limits = before;
  return result;
}

std::optional<VerifiedBox> SuiteSearch::best(const BoxMap& map, const SuiteGrid& grid, double bar) {
  std::vector<BoxedDamper> found = map.best(goal_, candidate_counts.at(space_.size()));
  std::erase_if(found, [&](const BoxedDamper& each) { return each.rank.value > hopeless * bar; });
  found = all_refined(std::move(found), grid, bar);
  std::optional<VerifiedBox> best;
  std::size_t count = 0;
  for (const BoxedDamper& each : found) {
    const double least = best ? std::min(bar, best->box.rank.value) : bar;
    if (watch_.stopped() || count == most_verified || each.rank.off > 0 ||
        each.rank.value >= least) {
      continue;
    }
    std::optional<VerifiedBox> now = verified(each);
    if (now && now->box.rank.value < least) {
      best = now;
      ++count;
    }
  }
  return best;
}

}  // namespace stillpoint::design
