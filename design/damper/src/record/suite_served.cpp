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

constexpr std::size_t beside_values = 5;  // of each that varies beside

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
  /// With `lets_rest` loads that hold the mass at its start are kept as well.
  Serves(const RecordDesignRequest& request, const SuiteDamper& damper, bool lets_rest)
      : task_(of_one_load(request)),
        suites_(task_),
        limits_(limits_of(task_)),
        damper_(damper),
        lets_rest_(lets_rest) {}

  /// At each factor of the loads and of the spring, with all that varies beside.
  [[nodiscard]] std::vector<bool> keeps(const Factors& loads, const Factors& springs,
                                        const Beside& beside) const {
    std::vector<SuiteDamper> dampers;
    std::vector<double> factors;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      for (const double part : values_in(beside.loads, beside_values)) {
        for (const double spring : values_in(
                 {1 / (1 + beside.spring.above), 1 / (1 - beside.spring.below)}, beside_values)) {
          for (const double damping :
               values_in({0, task_.zeta.low < task_.zeta.high ? 1.0 : 0.0}, beside_values)) {
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
        all.push_back(
            Suites(enlarged(task_, factors[i])).figures(relative_to(dampers[i], 1 / factors[i])));
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
  bool lets_rest_;
};

}  // namespace

std::optional<WorksFor> works_for(const RecordDesignRequest& request, const SuiteDamper& damper) {
  if (auto known = TaskAlongF::works_for(request, damper)) {
    return known;
  }
  const LoadCase& load = request.cases.front();
  const bool alone = request.cases.size() == 1;
  const bool to_nothing = alone && load.weakest == 0;
  const Interval loads_of_task{alone ? std::max(least_weakest, load.weakest) : 1, 1};
  const Serves serves(request, damper, to_nothing);
  if (!serves.keeps({1}, {1}, {loads_of_task, request.spring}).front()) {
    return std::nullopt;
  }
  const auto of_loads = [&](const Factors& factors) {
    return serves.keeps(factors, Factors(factors.size(), 1), {{1, 1}, request.spring});
  };
  const auto of_springs = [&](const Factors& factors) {
    return serves.keeps(Factors(factors.size(), 1), factors, {loads_of_task, {}});
  };
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
