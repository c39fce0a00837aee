// SPDX-License-Identifier: MIT
#include "record/suite_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace stillpoint::design {

namespace {

/// By the number of variables: where three are moved, 48 leave gaps in which a limit breaks.
constexpr std::array<std::size_t, most_axes + 1> sample_counts{48, 48, 48, 160, 160, 320, 320};
constexpr std::size_t few_samples = 16;
/// After so many, boxes that a sample rules out are dropped, since those that did most harm last
/// rule out most, and of the others all but the best.
struct SampleStage {
  std::size_t samples;
  std::size_t kept;
};
constexpr std::array<SampleStage, 5> sample_stages{
    {{2, SIZE_MAX}, {8, SIZE_MAX}, {20, 8}, {56, 4}, {SIZE_MAX, 1}}};
constexpr double last_step = 4e-4;  ///< of a value, relative
constexpr int most_moves = 6;       ///< at each step
/// Of a step: a move that gains less is not followed by another with the same step.
constexpr double least_gained = 1.0 / 16;
/// Of limits that a box misses, in steps: it gets no farther than its moves take it.
constexpr double out_of_reach = 24;
/// A candidate that is this much worse than the bar will not get below it: on the map, by a few
/// samples, and refined twice.
constexpr double hopeless = 1.01;
constexpr double beyond = 1.05;
constexpr double unlikely = 1.02;
/// Nor will one that is this much worse than the best candidate.
constexpr double mediocre = 1.08;
/// Where the surest candidates miss the limits by more than this, refined or polished, so do the
/// others.
constexpr double missed = 0.01;
/// One that is off by more stays so if a step mends less than this part; and of several, the surest
/// alone is polished.
constexpr double far_off = 0.02;
constexpr double least_mended = 0.0625;
/// Candidates of the map may lie this part of a box apart: it is too coarse to choose between them.
constexpr double spacing = 0.25;

/// Steps to a box, and to each side of a candidate, by the number of axes.
constexpr std::array<std::int64_t, most_axes + 1> most_windows{1, 256, 16, 8, 4, 4, 4};
constexpr std::array<std::int64_t, most_axes + 1> reaches{1, 6, 3, 1, 1, 1, 1};
constexpr std::array<std::size_t, most_axes + 1> most_refined{1, 2, 2, 2, 2, 2, 2};
constexpr std::array<std::size_t, most_axes + 1> pool_sizes{1, 24, 48, 48, 48, 48, 48};
constexpr std::array<std::size_t, most_axes + 1> candidate_counts{1, 4, 6, 6, 8, 8, 8};

/// The surest as it was found stays the first; then the surest now, then the others by merit.
void by_promise(std::vector<BoxedDamper>& list) {
  const auto rest = std::span(list).subspan(std::min<std::size_t>(1, list.size()));
  std::ranges::stable_sort(rest, {}, merit);
  const auto surest = std::ranges::min_element(rest, {}, &BoxedDamper::rank);
  if (surest != rest.end()) {
    std::rotate(rest.begin(), surest, surest + 1);
  }
}

}  // namespace

double merit(const BoxedDamper& box) {
  constexpr double price = 2;
  constexpr double least = 1e-3;  // of the stroke: of a residual of 0 what is off counts too
  const auto& [off, value, peak] = box.rank;
  return settled(box.worst) ? (value > 0 ? value : least * peak) * (1 + price * off) : HUGE_VAL;
}

SuiteSearch::SuiteSearch(const Suites& suite, const RecordDesignRequest& task,
                         const SuiteSpace& space, SuiteGoal goal, SuiteWatch& watch, bool brief)
    : suite_(suite),
      task_(task),
      space_(space),
      goal_(std::move(goal)),
      watch_(watch),
      brief_(brief),
      known_(space),
      samples_(box_samples(space, sample_counts.at(space.searched()))) {}

std::vector<TaskFigures> SuiteSearch::figures(const std::vector<SuiteDamper>& dampers) {
  if (dampers.empty()) {
    return {};
  }
  std::vector<TaskFigures> list = suite_.figures(dampers, task_.threads);
  watch_.evaluated(std::ssize(dampers));
  known_.add(dampers, list);
  return list;
}

/// The box of a damper by the samples, which are sorted by how near to a limit each of them is, or
/// to the worst value of the objective: where it decides, a better box nearby is likely to fail.
BoxedDamper SuiteSearch::sampled(const SuiteDamper& damper) {
  std::vector<SuiteDamper> dampers;
  dampers.reserve(samples_.size());
  for (const SuitePlace& unit : samples_) {
    dampers.push_back(space_.off(damper, unit));
  }
  const std::vector<TaskFigures> all = figures(dampers);
  const TaskFigures worst = worst_of(all);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::greater(), [&](std::size_t i) {
    return !settled(all[i]) ? HUGE_VAL
           : goal_.figure == nullptr
               ? use(all[i], goal_.limits)
               : std::max(use(all[i], goal_.limits), goal_.value(all[i]) / goal_.value(worst));
  });
  std::vector<SuitePlace> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) {
    sorted.push_back(samples_[i]);
  }
  samples_ = std::move(sorted);
  return known(damper);
}

std::vector<BoxedDamper> SuiteSearch::roughly(const std::vector<BoxedDamper>& found) {
  const std::vector<SuitePlace> places = box_samples(space_, few_samples);
  std::vector<SuiteDamper> dampers;
  for (const BoxedDamper& each : found) {
    for (const SuitePlace& unit : places) {
      dampers.push_back(space_.off(each.damper, unit));
    }
  }
  const std::vector<TaskFigures> all = figures(dampers);
  std::vector<BoxedDamper> list;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto of_box = std::span(all).subspan(k * places.size(), places.size());
    list.push_back(boxed(found[k].damper, worst_of(of_box)));
  }
  return list;
}

/// Long steps reach along a narrow valley; with more than two variables they are taken one at a
/// time, and `far` only.
std::vector<SuiteDamper> SuiteSearch::around(const SuiteDamper& damper, double step,
                                             bool far) const {
  static constexpr std::array steps{-1.0, 1.0, -4.0, 4.0};
  struct Move {
    SuitePlace place;
    int long_steps;
  };
  std::vector<Move> moves{{space_.place(damper), 0}};
  for (std::size_t i = 0; i < space_.size(); ++i) {
    const SuiteAxis& axis = space_.axes()[i];
    const std::size_t count = axis.searched() ? moves.size() : 0;
    for (std::size_t k = 0; k < count; ++k) {
      for (const double by : steps) {
        Move move = moves[k];
        move.place.at(i) = std::clamp(move.place.at(i) + by * step, axis.low(), axis.high());
        move.long_steps += std::abs(by) > 1 ? 1 : 0;
        moves.push_back(move);
      }
    }
  }
  std::vector<SuiteDamper> list;
  for (std::size_t k = 1; k < moves.size(); ++k) {
    if (space_.searched() <= 2 ? !far : moves[k].long_steps == (far ? 1 : 0)) {
      list.push_back(space_.at(moves[k].place));
    }
  }
  return list;
}

/// The best of them if it is better than `bar`, else that. A sample that is worse rules a box out.
BoxedDamper SuiteSearch::best_of(const std::vector<SuiteDamper>& dampers, const BoxedDamper& bar) {
  std::vector<BoxedDamper> left;
  left.reserve(dampers.size());
  for (const SuiteDamper& damper : dampers) {
    left.push_back(known(damper));
  }
  const auto keep = [&](std::size_t most) {
    std::erase_if(left, [&](const BoxedDamper& each) { return !(each.rank < bar.rank); });
    std::ranges::stable_sort(left, {}, &BoxedDamper::rank);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(std::min(left.size(), most)), left.end());
  };
  keep(SIZE_MAX);
  std::size_t begin = 0;
  for (const SampleStage& stage : sample_stages) {
    const std::size_t end = std::min(stage.samples, samples_.size());
    std::vector<SuiteDamper> tries;
    for (const BoxedDamper& each : left) {
      for (std::size_t i = begin; i < end; ++i) {
        tries.push_back(space_.off(each.damper, samples_[i]));
      }
    }
    const std::vector<TaskFigures> all = figures(tries);
    std::size_t next = 0;
    for (BoxedDamper& each : left) {
      for (std::size_t i = begin; i < end; ++i) {
        worsen(each.worst, all[next++]);
      }
      each.rank = rank(each.worst, goal_);
    }
    keep(stage.kept);
    begin = end;
  }
  return left.empty() ? bar : left.front();
}

BoxedDamper SuiteSearch::unbroken(const SuiteDamper& damper) {
  BoxedDamper broken{damper, {}, {}};
  broken.rank.off = std::numeric_limits<double>::min();
  return best_of({damper}, broken);
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

BoxedDamper SuiteSearch::polished(const BoxedDamper& from, double step, bool enough, double bar) {
  constexpr double coarse = 4;  // is enough for what may be off by more
  const double last = (space_.toleranced() > 0 ? coarse : 1) * last_step;
  BoxedDamper best = sampled(from.damper);
  for (; step >= last && !(enough && best.rank.off == 0) &&
         best.rank.value < bar * (1 + step / 2) && (enough || best.rank.off < out_of_reach * step);
       step /= 2) {
    const double off = best.rank.off;
    for (int i = 0; i < most_moves && !watch_.stopped(); ++i) {
      const SuiteRank before = best.rank;
      BoxedDamper now = best;
      for (const bool far : {false, true}) {
        now = now.rank < before ? now : best_of(around(best.damper, step, far), best);
      }
      best = known(best.damper);  // its neighbours may have told more of it
      if (now.rank < before) {
        best = sampled(now.damper);
      } else if (best.rank == before) {
        break;
      }
      const double least = least_gained * step;
      if (best.rank.off <= before.off && best.rank.off > before.off - least &&
          best.rank.value <= before.value && best.rank.value > (1 - least) * before.value) {
        break;
      }
    }
    if (!enough && std::min(off, best.rank.off) > far_off &&
        off - best.rank.off < least_mended * off) {
      break;
    }
  }
  return best;
}

BoxedDamper SuiteSearch::refined(BoxedDamper candidate, SuiteGrid& grid, int levels) {
  const std::size_t axes = space_.size();
  const std::int64_t most = most_windows.at(axes);
  // Valleys of three variables run across the map.
  const std::int64_t reach = axes == 3 && space_.searched() == 3 ? 3 : reaches.at(axes);
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
    const SuiteGrid patch = grid_about(space_, grid, candidate.damper, reach);
    const BoxMap map(space_, patch, grid_figures(suite_, space_, patch, task_.threads, watch_));
    const std::vector<BoxedDamper> best = map.best(goal_, 1);
    if (!best.empty()) {
      candidate = best.front();
    }
  }
  return candidate;
}

std::vector<BoxedDamper> SuiteSearch::shortlist(const std::vector<BoxedDamper>& found,
                                                const SuiteGrid& grid, double bar) {
  std::vector<BoxedDamper> list = roughly(found);
  if (list.empty()) {
    return list;
  }
  const BoxedDamper surest = std::ranges::min(list, {}, &BoxedDamper::rank);
  std::ranges::stable_sort(list, {}, merit);
  const double most = std::min(mediocre * merit(list.front()), beyond * bar);
  const std::size_t count = brief_ ? 1 : candidate_counts.at(space_.size());
  std::vector<BoxedDamper> chosen{surest};
  for (const BoxedDamper& each : list) {
    if (merit(each) <= most && chosen.size() < count &&
        std::ranges::none_of(chosen, [&](const BoxedDamper& other) {
          return are_near(space_.place(each.damper), space_.place(other.damper), grid);
        })) {
      chosen.push_back(each);
    }
  }
  return chosen;
}

std::vector<BoxedDamper> SuiteSearch::all_refined(const std::vector<BoxedDamper>& found,
                                                  const SuiteGrid& grid, double bar) {
  constexpr int first_levels = 2;
  constexpr int most_levels = 64;
  const std::size_t sure = brief_ ? 1 : 2;
  SuiteGrid fine = grid;
  std::vector<BoxedDamper> list = shortlist(found, grid, bar);
  double least_off = HUGE_VAL;
  for (std::size_t i = 0; i < list.size(); ++i) {
    fine = grid;
    list[i] = refined(list[i], fine, first_levels);
    least_off = std::min(least_off, list[i].rank.off);
    if (i + 1 >= sure && least_off > missed) {
      list.resize(i + 1);
    }
  }
  std::size_t most = brief_ ? 1 : most_refined.at(space_.size());
  if (least_off > far_off) {
    std::ranges::stable_sort(list, {}, &BoxedDamper::rank);
    most = 1;
  } else {
    by_promise(list);
  }
  std::erase_if(list, [&](const BoxedDamper& each) { return each.rank.value > unlikely * bar; });
  std::size_t tried = 0;
  std::size_t admissible_ones = 0;
  least_off = HUGE_VAL;
  for (BoxedDamper& each : list) {
    if (admissible_ones == most || tried == 2 * most || (tried == most && least_off > missed)) {
      break;
    }
    ++tried;
    SuiteGrid finest = fine;
    each = polished(refined(each, finest, most_levels), first_step(), false, bar);
    least_off = std::min(least_off, each.rank.off);
    if (each.rank.off == 0) {
      bar = std::min(bar, each.rank.value);
      ++admissible_ones;
    }
  }
  // The others follow as they are: samples may yet find that all that were polished fail.
  const auto others = list.begin() + static_cast<std::ptrdiff_t>(tried);
  list.erase(std::remove_if(others, list.end(),
                            [&](const BoxedDamper& each) { return brief_ || each.rank.off > 0; }),
             list.end());
  std::stable_sort(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(tried),
                   [](const BoxedDamper& a, const BoxedDamper& b) { return a.rank < b.rank; });
  return list;
}

std::vector<BoxedDamper> SuiteSearch::likeliest(const BoxMap& map, const SuiteGrid& grid,
                                                double bar) {
  std::vector<BoxedDamper> found = map.best(goal_, pool_sizes.at(space_.size()), spacing);
  std::erase_if(found, [&](const BoxedDamper& each) {
    return !settled(each.worst) || each.rank.value > hopeless * bar ||
           each.rank.off > out_of_reach * first_step();
  });
  return all_refined(found, grid, bar);
}

}  // namespace stillpoint::design
