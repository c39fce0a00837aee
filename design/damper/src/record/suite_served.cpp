// SPDX-License-Identifier: MIT
#include "record/suite_served.hpp"

#include "record/suite_outlook.hpp"
#include "record/suite_request.hpp"

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

/// With the least and the most damping.
std::vector<TaskFigures> figures_of(const Suites& suites, std::vector<SuiteDamper> dampers,
                                    const RecordDesignRequest& task) {
  std::vector<TaskFigures> all = suites.figures(dampers, task.threads);
  if (task.zeta.low < task.zeta.high) {
    for (SuiteDamper& damper : dampers) {
      damper.damping = 1;
    }
    std::ranges::transform(all, suites.figures(dampers, task.threads), all.begin(),
                           [](const auto& a, const auto& b) { return worse(a, b); });
  }
  return all;
}

/// Whether the loads that must move the mass do.
bool starts(const RecordDesignRequest& task, const SuiteDamper& damper) {
  return damper.f <= task.f_start.value_or(HUGE_VAL) &&
         damper.f <= most_in_dead_zone(task, damper.p) &&
         damper.delta <= task.delta_start.value_or(HUGE_VAL);
}

}  // namespace

std::optional<WorksFor> works_for(const RecordDesignRequest& request, const SuiteDamper& damper) {
  RecordDesignRequest task = request;  // of one load each, where it has ranges
  task.judges = true;
  for (LoadCase& each : task.cases) {
    each.weakest = 1;
  }
  bound_starts(task);
  const Suites suites(task);
  const std::vector<SuiteLimits> limits = limits_of(task);
  if (!starts(task, damper) || !admissible(figures_of(suites, {damper}, task).front(), limits)) {
    return std::nullopt;
  }
  const auto kept = [&](const std::vector<SuiteDamper>& dampers,
                        const std::vector<TaskFigures>& all) {
    std::vector<bool> result;
    for (std::size_t i = 0; i < all.size(); ++i) {
      result.push_back(starts(task, dampers[i]) && admissible(all[i], limits));
    }
    return result;
  };
  const auto of_loads = [&](const Factors& factors) {
    std::vector<SuiteDamper> dampers;
    for (const double factor : factors) {
      dampers.push_back(relative_to(damper, factor));
    }
    std::vector<TaskFigures> all = figures_of(suites, dampers, task);
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (SuiteFigures& figures : all[i]) {
        figures = times(figures, factors[i]);
      }
    }
    return kept(dampers, all);
  };
  // What a notch holds is not relative to the load.
  const auto of_held = [&](const Factors& factors) {
    std::vector<SuiteDamper> dampers;
    std::vector<TaskFigures> all;
    for (const double factor : factors) {
      dampers.push_back(relative_to(damper, factor));
      all.push_back(figures_of(Suites(enlarged(task, factor)), {damper}, task).front());
    }
    return kept(dampers, all);
  };
  const auto of_springs = [&](const Factors& factors) {
    std::vector<SuiteDamper> dampers;
    for (const double factor : factors) {
      dampers.push_back({factor * damper.p, damper.f, damper.delta, damper.width});
    }
    return kept(dampers, figures_of(suites, dampers, task));
  };
  const LoadCase& load = task.cases.front();
  const bool alone = task.cases.size() == 1;
  const ServedLoad of = alone && load.v0      ? ServedLoad::v0
                        : alone && load.pulse ? ServedLoad::k
                                              : ServedLoad::scale;
  const double value = of == ServedLoad::v0  ? *load.v0
                       : of == ServedLoad::k ? peak_load(*load.pulse)
                                             : 1;
  constexpr Interval loads{0.1, 10};
  constexpr Interval springs{0.5, 2};
  return WorksFor{about(value, task.hold ? Keeps(of_held) : Keeps(of_loads), loads),
                  about(damper.p, of_springs, springs), of};
}

}  // namespace stillpoint::design
