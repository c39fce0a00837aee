// SPDX-License-Identifier: MIT
#include "record/suite_served.hpp"

#include "record/suite_outlook.hpp"
#include "record/suite_request.hpp"
#include "record/task_along_f.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace stillpoint::design {

namespace {

using Factors = std::vector<double>;
/// Whether the damper keeps every limit at each factor.
using Keeps = std::function<std::vector<bool>(const Factors&)>;

constexpr double factor_step = 1.01;
constexpr std::size_t parts = 32;  // of a step, and of a part of it
constexpr int rounds = 4;          // to a millionth of a step

/// From one that keeps them to one that does not: the last that does.
double last_kept(const Keeps& keeps, double kept, double broken) {
  for (int round = 0; round < rounds; ++round) {
    Factors between;
    for (std::size_t i = 1; i < parts; ++i) {
      between.push_back(
          std::lerp(kept, broken, static_cast<double>(i) / static_cast<double>(parts)));
    }
    const std::vector<bool> all = keeps(between);
    const auto first = static_cast<std::size_t>(std::ranges::find(all, false) - all.begin());
    broken = first < between.size() ? between[first] : broken;
    kept = first > 0 ? between[first - 1] : kept;
  }
  return kept;
}

/// The farthest towards `end` with all kept up to there.
double reach(const Keeps& keeps, double end) {
  const double by = end > 1 ? factor_step : 1 / factor_step;
  Factors factors;
  for (double factor = by; (end > 1) == (factor < end); factor *= by) {
    factors.push_back(factor);
  }
  factors.push_back(end);
  const std::vector<bool> all = keeps(factors);
  const auto first = static_cast<std::size_t>(std::ranges::find(all, false) - all.begin());
  return first == factors.size()
             ? end
             : last_kept(keeps, first > 0 ? factors[first - 1] : 1.0, factors[first]);
}

ServedInterval about(double value, const Keeps& keeps, const Interval& ends) {
  const double low = reach(keeps, ends.low);
  const double high = reach(keeps, ends.high);
  return {value * low, value * high, low == ends.low || high == ends.high};
}

/// Evenly from end to end.
std::vector<double> through(const Interval& range) {
  constexpr int steps = 4;
  std::vector<double> values{range.low};
  for (int i = 1; i <= steps && range.low < range.high; ++i) {
    values.push_back(std::lerp(range.low, range.high, static_cast<double>(i) / steps));
  }
  return values;
}

/// What varies beside what is looked for: parts of the load, springs, or none of them.
struct Beside {
  Interval loads{1, 1};
  Spread spring{};
};

/// Whether the loads that must move the mass do, for a damper relative to that factor of them.
bool starts(const RecordDesignRequest& task, const SuiteDamper& damper, double factor) {
  return damper.f <= task.f_start.value_or(HUGE_VAL) &&
         damper.f * factor <= most_in_dead_zone(task, damper.p) &&
         damper.delta <= task.delta_start.value_or(HUGE_VAL);
}

class Serves {
 public:
  Serves(const RecordDesignRequest& request, const SuiteDamper& damper)
      : task_(of_one_load(request)), suites_(task_), limits_(limits_of(task_)), damper_(damper) {}

  /// At each factor of the loads and of the spring, with all that varies beside.
  [[nodiscard]] std::vector<bool> keeps(const Factors& loads, const Factors& springs,
                                        const Beside& beside) const {
    std::vector<SuiteDamper> dampers;
    std::vector<double> factors;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      for (const double part : through(beside.loads)) {
        for (const double spring :
             through({1 / (1 + beside.spring.above), 1 / (1 - beside.spring.below)})) {
          for (const double damping : through({0, task_.zeta.low < task_.zeta.high ? 1.0 : 0.0})) {
            SuiteDamper now = damper_;
            now.p *= springs[i] * spring;
            now.damping = damping;
            dampers.push_back(relative_to(now, loads[i] * part));
            factors.push_back(loads[i] * part);
          }
        }
      }
    }
    const std::vector<TaskFigures> all = figures(dampers, factors);
    const std::size_t each = all.size() / loads.size();
    std::vector<bool> result;
    for (std::size_t i = 0; i < all.size(); i += each) {
      bool kept = true;
      for (std::size_t k = i; k < i + each; ++k) {
        kept = kept &&
               (starts(task_, dampers[k], factors[k]) ? admissible(all[k], limits_) : lets_rest_);
      }
      result.push_back(kept);
    }
    return result;
  }

  [[nodiscard]] const RecordDesignRequest& task() const { return task_; }
  /// Every load down to nothing is one of the task, of which it holds some.
  void let_rest() { lets_rest_ = true; }

 private:
  static RecordDesignRequest of_one_load(RecordDesignRequest task) {
    task.judges = true;
    for (LoadCase& each : task.cases) {
      each.weakest = 1;
    }
    bound_starts(task);
    return task;
  }

  /// Of the loads times the factors. What a notch holds is not relative to them.
  [[nodiscard]] std::vector<TaskFigures> figures(const std::vector<SuiteDamper>& dampers,
                                                 const Factors& factors) const {
    std::vector<TaskFigures> all;
    if (!task_.hold) {
      all = suites_.figures(dampers, task_.threads);
    }
    for (std::size_t i = 0; i < dampers.size(); ++i) {
      if (task_.hold) {
        SuiteDamper own = dampers[i];
        all.push_back(
            Suites(enlarged(task_, factors[i])).figures(relative_to(own, 1 / factors[i])));
      } else {
        for (SuiteFigures& one : all[i]) {
          one = times(one, factors[i]);
        }
      }
    }
    return all;
  }

  RecordDesignRequest task_;
  Suites suites_;
  std::vector<SuiteLimits> limits_;
  SuiteDamper damper_;
  bool lets_rest_{false};
};

}  // namespace

std::optional<WorksFor> works_for(const RecordDesignRequest& request, const SuiteDamper& damper) {
  if (auto known = TaskAlongF::works_for(request, damper)) {
    return known;
  }
  Serves serves(request, damper);
  const bool alone = request.cases.size() == 1;
  const bool to_nothing = alone && request.cases.front().weakest == 0;
  const Interval loads_of_task{alone ? std::max(least_weakest, request.cases.front().weakest) : 1,
                               1};
  if (to_nothing) {
    serves.let_rest();
  }
  if (!serves.keeps({1}, {1}, {loads_of_task, request.spring}).front()) {
    return std::nullopt;
  }
  const auto of_loads = [&](const Factors& factors) {
    return serves.keeps(factors, Factors(factors.size(), 1), {{1, 1}, request.spring});
  };
  const auto of_springs = [&](const Factors& factors) {
    return serves.keeps(Factors(factors.size(), 1), factors, {loads_of_task, {}});
  };
  const LoadCase& load = request.cases.front();
  const ServedLoad of = alone && load.v0      ? ServedLoad::v0
                        : alone && load.pulse ? ServedLoad::k
                                              : ServedLoad::scale;
  const double value = of == ServedLoad::v0  ? *load.v0
                       : of == ServedLoad::k ? peak_load(*load.pulse)
                                             : 1;
  constexpr Interval loads{0.1, 10};
  constexpr Interval springs{0.5, 2};
  WorksFor found{about(value, of_loads, loads), about(damper.p, of_springs, springs), of};
  if (to_nothing && found.hit.low <= value * loads.low) {
    found.hit.low = 0;
    found.hit.ends_search = *found.hit.high >= value * loads.high;
  }
  return found;
}

}  // namespace stillpoint::design
