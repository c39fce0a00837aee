// SPDX-License-Identifier: MIT
#include "record/suite_region.hpp"

#include "record/suite_judge.hpp"
#include "record/suite_samples.hpp"
#include "record/suite_space.hpp"
#include "record/task_along_f.hpp"

#include <stillpoint/core/input_error.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace stillpoint::design {

namespace {

/// Values along each side of a map, each map of what the one before shows.
constexpr std::size_t values_along = 60;
constexpr int narrowings = 2;
/// Of the box of each where its corners are not known to be the worst.
constexpr std::size_t samples = 64;
/// Of a cell of a map, to find an edge in it.
constexpr int edge_halvings = 24;

/// The ranges of what is `good` of the values, up to where `is_good` fails.
template <class Test>
std::vector<Interval> ranges_of(const std::vector<double>& values, const std::vector<bool>& good,
                                const Test& is_good) {
  const auto edge = [&](std::size_t from, std::size_t to) {
    double inside = values[from];
    double outside = values[to];
    for (int i = 0; i < edge_halvings; ++i) {
      const double middle = (inside + outside) / 2;
      (is_good(middle) ? inside : outside) = middle;
    }
    return inside;
  };
  std::vector<Interval> ranges;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (good[i] && (i == 0 || !good[i - 1])) {
      ranges.push_back({i == 0 ? values[i] : edge(i, i - 1), values[i]});
    }
    if (good[i]) {
      const bool last = i + 1 == values.size();
      ranges.back().high = last || good[i + 1] ? values[i] : edge(i, i + 1);
    }
  }
  return ranges;
}

class FeasibleDampers {
 public:
  FeasibleDampers(const Suites& suites, const RecordDesignRequest& task)
      : suites_(suites), task_(task), limits_(limits_of(task)), f_(*task.f), delta_(*task.delta) {}

  FeasibleRegion found() {
    FeasibleRegion region;
    for (int i = 0; i < narrowings; ++i) {
      if (!narrow()) {
        return region;
      }
    }
    const std::vector<double> deltas = values_in(delta_, values_along);
    const auto any = [&](double f) {
      const std::vector<bool> good = are_good(f, deltas);
      return std::ranges::find(good, true) != good.end();
    };
    const std::vector<double> fs = values_in(f_, values_along);
    std::vector<bool> good;
    std::ranges::transform(fs, std::back_inserter(good), any);
    region.f = ranges_of(fs, good, any);
    if (region.f.empty()) {
      return region;
    }
    for (const double f :
         values_in({region.f.front().low, region.f.back().high}, told_values_of_f)) {
      const auto is_good = [&](double delta) -> bool { return are_good(f, {delta}).front(); };
      for (const Interval& delta : ranges_of(deltas, are_good(f, deltas), is_good)) {
        region.deltas.push_back({f, delta});
      }
    }
    return region;
  }

 private:
  /// To where anything is feasible, and a cell about it; false where nothing is.
  bool narrow() {
    Interval f{HUGE_VAL, 0};
    Interval delta{HUGE_VAL, 0};
    const std::vector<double> deltas = values_in(delta_, values_along);
    const auto include = [](Interval& seen, double value) {
      seen = {std::min(seen.low, value), std::max(seen.high, value)};
    };
    for (const double of_f : values_in(f_, values_along)) {
      const std::vector<bool> good = are_good(of_f, deltas);
      for (std::size_t i = 0; i < deltas.size(); ++i) {
        if (good[i]) {
          include(f, of_f);
          include(delta, deltas[i]);
        }
      }
    }
    const auto about = [](const Interval& seen, const Interval& whole) {
      const double cell = (whole.high - whole.low) / static_cast<double>(values_along - 1);
      return Interval{std::max(seen.low - cell, whole.low), std::min(seen.high + cell, whole.high)};
    };
    if (f.high < f.low) {
      return false;
    }
    f_ = about(f, f_);
    delta_ = about(delta, delta_);
    return true;
  }

  /// Of dampers with that f.
  [[nodiscard]] std::vector<bool> are_good(double f, const std::vector<double>& deltas) const {
    std::vector<SuiteDamper> all;
    std::vector<std::size_t> ends;
    for (const double delta : deltas) {
      add_corners({task_.p.low, f, delta, delta > 0 && task_.width ? task_.width->low : 0}, all);
      ends.push_back(all.size());
    }
    const std::vector<TaskFigures> figures = suites_.figures(all, task_.threads);
    std::vector<bool> good;
    std::size_t i = 0;
    for (const std::size_t end : ends) {
      bool holds = i < end;
      for (; i < end; ++i) {
        holds = holds && admissible(figures[i], limits_);
      }
      good.push_back(holds);
    }
    return good;
  }

  /// The damper and samples of its box; none where it cannot be built or moved.
  void add_corners(const SuiteDamper& damper, std::vector<SuiteDamper>& all) const {
    if (damper.f + damper.delta == 0 ||
        !std::ranges::all_of(constraints_on(task_, damper), &Constraint::satisfied)) {
      return;
    }
    all.push_back(damper);
    const SuiteSpace space(task_, frictions_of(damper));
    if (space.toleranced() > 0) {
      for (const SuitePlace& unit : box_samples(space, samples)) {
        all.push_back(space.off(damper, unit));
      }
    }
  }

  const Suites& suites_;
  const RecordDesignRequest& task_;
  std::vector<SuiteLimits> limits_;
  Interval f_;
  Interval delta_;
};

}  // namespace

FeasibleRegion feasible_region(const Suites& suites, const RecordDesignRequest& task) {
  if (const LoadCase& only = task.cases.front(); only.weakest == 0) {
    throw InputError(only.pulse ? "k" : "v0", 0.0,
                     "must be greater than 0 where the range begins, so that the weakest load "
                     "moves the mass; or give f and delta of a damper to judge");
  }
  return FeasibleDampers(suites, task).found();
}

}  // namespace stillpoint::design
