// SPDX-License-Identifier: MIT
// The best f of a pulse's islands, in two ways. NLopt searches f, and the tolerance for `robust`;
// Delta follows from both. Beside it stands the optimum along f alone. docs/theory.md section 8.

#include "pulse/region.hpp"

#include "pulse/task.hpp"

#include <stillpoint/core/seconds.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace stillpoint::design {

namespace {

/// The intervals of an island that have room for a box of the tolerance asked for. They keep a
/// relative 1e-9 from its edges and from delta_max if there is room for that: an edge is a graze,
/// or a peak that is beta to the last digit, and a need equal to delta_max to the last digit may
/// exceed it in a run that rounds differently. The last try knows as little as
/// PulseRegion::feasible, so that a box of a mend, which fits to the last bit, is found.
std::vector<PulseTask> tasks_in(const PulseRegion& region, const Island& whole, Objective objective,
                                KnownMotions& known) {
  constexpr double inset = 1e-9;
  std::vector<PulseTask> tasks;
  std::optional<KnownMotions> fresh;
  for (const Island& island : {Island{whole.low * (1 + inset), whole.high * (1 - inset)}, whole}) {
    for (const double most_use : {1 - inset, 1.0}) {
      if (!tasks.empty() || island.low > island.high) {
        continue;
      }
      const bool last_try = island.low == whole.low && most_use == 1.0;
      KnownMotions& knows = last_try ? fresh.emplace(*region.profile()) : known;
      for (const Island& part : region.parts(island, region.asked(), most_use, knows)) {
        if (region.spare(part, region.asked()) >= 0) {
          tasks.push_back({region, known, objective, part, most_use});
        }
      }
    }
  }
  return tasks;
}

PulseBest searched(const PulseTask& task, double scale, const SearchOptions& options,
                   SearchRecord& record) {
  PulseBest best;
  std::vector<double> visited;
  const auto judge = [&] {
    for (; !visited.empty(); visited.pop_back()) {  // the last ones are the best
      best.consider(task, visited.back());
    }
  };
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  const NloptProblem problem =
      posed(task, algorithm, scale, [&](double f) { visited.push_back(f); });
  const NloptOutcome outcome = run(problem, algorithm.name, options, [&]() -> Eigen::VectorXd {
    judge();
    return best.f ? Eigen::VectorXd::Constant(1, *best.f / task.part.high) : problem.start;
  });
  visited.push_back(outcome.x[0] * task.part.high);
  judge();
  record.algorithm = algorithm.name;
  record.status = outcome.status;
  record.evaluations += outcome.evaluations;
  return best;
}

}  // namespace

std::optional<PulseOptimum> search(const PulseRegion& region, const SearchOptions& options) {
  const double started = seconds_now();
  std::optional<PulseOptimum> best;
  SearchRecord record;
  KnownMotions known(*region.profile());
  double least = HUGE_VAL;
  double searched_least = HUGE_VAL;
  double bracketed_least = HUGE_VAL;
  for (const Island& whole : region.islands()) {
    for (const PulseTask& task : tasks_in(region, whole, options.objective, known)) {
      const PulseBest along = bracketed(task);
      const double scale = along.f && along.cost > 0 ? along.cost : 1;
      const PulseBest by_nlopt = searched(task, scale, options, record);
      searched_least = std::min(searched_least, by_nlopt.cost);
      bracketed_least = std::min(bracketed_least, along.cost);
      // Of equal tolerances, the one along f has the largest f, and so the least peak and Delta.
      // And the last digits of NLopt's depend on its version and on the processor.
      constexpr double better_by = 1e-8;
      const PulseBest& better =
          by_nlopt.cost < along.cost - better_by * std::abs(along.cost) ? by_nlopt : along;
      if (better.f && better.cost < least) {
        least = better.cost;
        best = PulseOptimum{{region.with_best_delta(task.part, *better.f, known), {}}, whole};
      }
    }
  }
  if (best) {
    record.wall_time_s = seconds_now() - started;
    best->found.record = record;
    best->searched = searched_least;
    best->bracketed = bracketed_least;
    auto& [f, delta, tolerance] = best->found.point;
    tolerance = std::max(tolerance, region.asked());
    if (region.reaches_down_to_0(best->island)) {  // the parts that are searched do not
      tolerance = std::max(tolerance, region.tolerance_of(f, delta).value_or(0));
    }
  }
  return best;
}

}  // namespace stillpoint::design
