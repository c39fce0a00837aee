// SPDX-License-Identifier: MIT
// The best f of a pulse's islands, in two ways. NLopt searches f, and the tolerance for `robust`;
// Delta follows from both. Beside it stands the optimum along f alone: the largest box by its
// edges, the other objectives by sampling and Brent's method. docs/theory.md section 8.

#include "pulse/search.hpp"

#include "pulse/edge.hpp"
#include "search/nlopt_fence.hpp"
#include "search/objectives.hpp"
#include "search/run.hpp"

#include <stillpoint/core/elementary.hpp>
#include <stillpoint/core/seconds.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace stillpoint::design {

namespace {

/// One island, kept a relative 1e-9 from its edges and from delta_max if there is room for that:
/// an edge is a graze, or a peak that is beta to the last digit, and a need equal to delta_max to
/// the last digit may exceed it in a run that rounds differently.
struct PulseTask {
  const PulseRegion& region;
  Objective objective;
  Island island;
  double most_use{1};  ///< of delta_max

  PulseTask(const PulseRegion& of, Objective what, const Island& whole)
      : region(of), objective(what), island(whole) {
    constexpr double inset = 1e-9;
    const Island inner{whole.low * (1 + inset), whole.high * (1 - inset)};
    if (inner.low < inner.high && region.box_in(inner, region.asked())) {
      island = inner;
    }
    if (region.box_in(island, region.asked(), 1 - inset)) {
      most_use = 1 - inset;
    }
  }

  [[nodiscard]] double cost(double f) const {
    return objective == Objective::robust ? -region.widest_box(island, f)
                                          : objective_of(objective, region.at(f));
  }
  /// The tolerance asked for is reached.
  [[nodiscard]] bool fits(double f) const { return room(f) >= 0; }
  /// The fraction of the island, else of delta_max, that the box of that tolerance leaves.
  [[nodiscard]] double room(double f) const {
    const double tolerance = region.asked();
    const double low = region.low_of(f, tolerance);
    const double high = region.high_of(f, tolerance);
    constexpr double rounding = 1e-14;
    const double within = std::min(low / (island.low * (1 - rounding)) - 1,
                                   1 - high / (island.high * (1 + rounding)));
    return within < 0 ? within
                      : most_use - region.use_of_delta(std::max(low, island.low),
                                                       std::min(high, island.high), tolerance);
  }
};

/// The best f of those that fit.
struct PulseBest {
  std::optional<double> f;
  double cost{HUGE_VAL};

  void consider(const PulseTask& task, double f_new) {
    const double inside = std::clamp(f_new, task.island.low, task.island.high);
    if (std::isnan(inside) || !task.fits(inside)) {
      return;
    }
    const double now = task.cost(inside);
    if (now < cost) {
      f = inside;
      cost = now;
    }
  }
};

/// The middle of the largest box that fits: boxes only get better as they shrink.
double middle_of_largest_box(const PulseTask& task) {
  const PulseRegion& region = task.region;
  const auto& island = task.island;
  const auto& [f_low, f_high, delta_low, delta_high] = region.shape();
  const double sides = island.high * f_low + island.low * f_high;
  const double by_edges = sides > 0 ? (island.high - island.low) / sides : HUGE_VAL;
  const double most = std::min(by_edges, region.most_tolerance());
  constexpr double rounding = 1e-15;
  double tolerance = std::max(region.asked(), most * (1 - rounding));
  const auto room = [&](double now) { return region.room_for(island, now, task.most_use); };
  if (tolerance > region.asked() && room(tolerance) < 0) {
    tolerance = last_not_negative(region.asked(), tolerance, room);
  }
  return region.middle_of(region.box_in(island, tolerance, task.most_use).value_or(island.low),
                          tolerance);
}

/// The samples between two f, with both ends, and with more where they are few.
std::vector<FirstReturn> looks_between(const PulseTask& task, double low, double high) {
  constexpr std::size_t enough = 8;
  std::vector<FirstReturn> looks{task.region.at(low)};
  for (const FirstReturn& now : task.region.profile()->samples()) {
    if (low < now.f && now.f < high) {
      looks.push_back(now);
    }
  }
  if (low < high) {
    looks.push_back(task.region.at(high));
  }
  for (std::size_t i = 1; looks.size() < enough && i < enough && low < high; ++i) {
    looks.push_back(
        task.region.at(low * elementary::pow(high / low, static_cast<double>(i) / enough)));
  }
  std::ranges::sort(looks, {}, &FirstReturn::f);
  return looks;
}

PulseBest bracketed(const PulseTask& task) {
  PulseBest best;
  const double tolerance = task.region.asked();
  const auto box = task.region.box_in(task.island, tolerance, task.most_use);
  if (task.objective == Objective::robust) {
    if (box) {
      best.consider(task, task.region.middle_of(*box, tolerance));
    }
    best.consider(task, middle_of_largest_box(task));
    return best;
  }
  const auto [low, high] = task.region.middles(task.island);
  const std::vector<FirstReturn> looks = looks_between(task, low, high);
  const FirstReturn* before = nullptr;
  std::size_t at_best = 0;
  for (const FirstReturn& now : looks) {
    const double least = best.cost;
    best.consider(task, now.f);
    at_best = best.cost < least ? static_cast<std::size_t>(&now - looks.data()) : at_best;
    if (before != nullptr && task.fits(now.f) != task.fits(before->f)) {
      // The end of what delta_max leaves.
      const bool fits = task.fits(now.f);
      best.consider(task, last_not_negative(fits ? now.f : before->f, fits ? before->f : now.f,
                                            [&](double f) { return task.room(f); }));
    }
    before = &now;
  }
  if (box) {
    best.consider(task, task.region.middle_of(*box, tolerance));
  }
  const double left = looks[at_best == 0 ? 0 : at_best - 1].f;
  const double right = looks[std::min(at_best + 1, looks.size() - 1)].f;
  // At an end from which the cost grows there is nothing to refine.
  constexpr double aside = 1e-4;
  const double end = looks[at_best].f;
  const double inside = at_best == 0 ? end + aside * (right - end) : end - aside * (end - left);
  const bool interior = left < end && end < right;
  if (best.f && left < right && (interior || task.cost(inside) < task.cost(end))) {
    constexpr int bits = 24;
    best.consider(task, boost::math::tools::brent_find_minima(
                            [&](double f) { return task.cost(f); }, left, right, bits)
                            .first);
  }
  return best;
}

/// The best f of the samples and of the ends, a start for NLopt; the middle for `robust`, and some
/// f that fits if that does not.
double start_of(const PulseTask& task) {
  PulseBest best;
  if (task.objective != Objective::robust) {
    const auto [low, high] = task.region.middles(task.island);
    best.consider(task, low);
    best.consider(task, high);
    for (const FirstReturn& now : task.region.profile()->samples()) {
      if (task.island.low <= now.f && now.f <= task.island.high) {
        best.consider(task, now.f);
      }
    }
  }
  const double middle = std::sqrt(task.island.low) * std::sqrt(task.island.high);
  if (best.f || task.fits(middle)) {
    return best.f.value_or(middle);
  }
  const auto box = task.region.box_in(task.island, task.region.asked());
  return box ? task.region.middle_of(*box, task.region.asked()) : middle;
}

/// By the difference to a value nearby, above it if that is within bounds.
template <class Value>
double slope(const Value& value, double at, const Island& within) {
  constexpr double part = 1e-7;
  const double above = at * (1 + part);
  const double other = above <= within.high ? above : std::max(within.low, at * (1 - part));
  return other != at ? (value(other) - value(at)) / (other - at) : 0;
}

/// x = f / high of the island and, for `robust`, t: the least -t or cost with
///   low / high - x (1 - t) <= 0,  x (1 + t) - 1 <= 0,  need (1 + t) / ((1 - t) delta_max) - 1 <=
///   0,
/// t times the part of its own on each side.
NloptProblem constrained(const PulseTask& task, double scale,
                         const std::function<void(double)>& visit) {
  const double high = task.island.high;
  const double low = task.island.low;
  const bool robust = task.objective == Objective::robust;
  const double asked = task.region.asked();
  const double most = task.region.most_tolerance();
  const double down = task.region.shape().f_low;
  const double up = task.region.shape().f_high;
  NloptProblem posed;
  const double start = start_of(task) / high;
  posed.lower = Eigen::VectorXd::Constant(1, low / high);
  posed.upper = Eigen::VectorXd::Constant(1, 1);
  posed.start = Eigen::VectorXd::Constant(1, start);
  if (robust) {
    posed.lower = Eigen::Vector2d(low / high, asked);
    posed.upper = Eigen::Vector2d(1, most);
    posed.start = Eigen::Vector2d(start, asked);
  }
  const auto box = [robust, asked](const Eigen::VectorXd& x) { return robust ? x[1] : asked; };
  const auto store = [](Eigen::VectorXd& gradient, double by_x, double by_t) {
    gradient = Eigen::Vector2d(by_x, by_t).head(gradient.size()).eval();
  };
  posed.objective = [=, &task](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    visit(x[0] * high);
    if (robust) {
      store(gradient, 0, -1);
      return -x[1];
    }
    const auto cost = [&](double f) { return task.cost(f) / scale; };
    if (gradient.size() > 0) {
      store(gradient, slope(cost, x[0] * high, task.island) * high, 0);
    }
    return cost(x[0] * high);
  };
  posed.constraints.emplace_back([=](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    store(gradient, -(1 - down * box(x)), down * x[0]);
    return low / high - x[0] * (1 - down * box(x));
  });
  posed.constraints.emplace_back([=](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    store(gradient, 1 + up * box(x), up * x[0]);
    return x[0] * (1 + up * box(x)) - 1;
  });
  if (std::isinf(task.region.delta_max())) {
    return posed;
  }
  const auto use = [=, &task](double f, double t) {
    const double box_low = std::clamp(f * (1 - down * t), low, high);
    // It converges on the edge from outside.
    constexpr double inset = 1e-9;
    return task.region.use_of_delta(box_low, std::clamp(f * (1 + up * t), box_low, high), t) -
           task.most_use * (1 - inset);
  };
  posed.constraints.emplace_back([=, &task](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double f = x[0] * high;
    const double t = box(x);
    if (gradient.size() > 0) {
      const auto by_f = [&](double now) { return use(now, t); };
      const auto by_t = [&](double now) { return use(f, now); };
      constexpr double small = 1e-7;
      store(gradient, slope(by_f, f, task.island) * high,
            !robust ? 0
            : t > 0 ? slope(by_t, t, {0, most})
                    : (by_t(small) - by_t(0)) / small);
    }
    return use(f, t);
  });
  return posed;
}

/// For algorithms that take only bounds: a point that does not fit costs more than any that does.
NloptProblem penalised(const PulseTask& task, double scale,
                       const std::function<void(double)>& visit) {
  const double asked = task.region.asked();
  NloptProblem posed;
  const Island middles = task.region.middles(task.island);
  posed.lower = Eigen::VectorXd::Constant(1, middles.low);
  posed.upper = Eigen::VectorXd::Constant(1, middles.high);
  posed.upper = posed.upper.cwiseMax(posed.lower);
  const double unit = posed.upper[0];
  posed.lower /= unit;
  posed.upper /= unit;
  posed.start = Eigen::VectorXd::Constant(1, start_of(task) / unit);
  constexpr double worse = 1e3;
  posed.objective = [=, &task](const Eigen::VectorXd& x, Eigen::VectorXd& /*gradient*/) {
    const double f = x[0] * unit;
    visit(f);
    return task.fits(f) ? task.cost(f) / scale
                        : worse + task.region.use_of_delta(task.region.low_of(f, asked),
                                                           task.region.high_of(f, asked), asked);
  };
  return posed;
}

PulseBest searched(const PulseTask& task, double scale, const SearchOptions& options,
                   SearchRecord& record) {
  PulseBest best;
  const auto visit = [&](double f) { best.consider(task, f); };
  const NloptAlgorithm algorithm = find_algorithm(options.algorithm);
  const bool takes_constraints = algorithm.constraints == ConstraintSupport::yes;
  const NloptProblem posed =
      takes_constraints ? constrained(task, scale, visit) : penalised(task, scale, visit);
  const Island middles = task.region.middles(task.island);
  const double unit = takes_constraints ? task.island.high : std::max(middles.high, middles.low);
  const NloptOutcome outcome = run(posed, algorithm.name, options, [&]() -> Eigen::VectorXd {
    return best.f ? Eigen::VectorXd::Constant(1, *best.f / middles.high) : posed.start;
  });
  best.consider(task, outcome.x[0] * unit);
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
  double least = HUGE_VAL;
  double searched_least = HUGE_VAL;
  double bracketed_least = HUGE_VAL;
  for (const Island& whole : region.islands()) {
    if (!region.box_in(whole, region.asked())) {
      continue;
    }
    const PulseTask task(region, options.objective, whole);
    const PulseBest along = bracketed(task);
    const double scale = along.f && along.cost > 0 ? along.cost : 1;
    const PulseBest by_nlopt = searched(task, scale, options, record);
    searched_least = std::min(searched_least, by_nlopt.cost);
    bracketed_least = std::min(bracketed_least, along.cost);
    // Of equal tolerances, the one along f has the largest f, and so the least peak and Delta.
    constexpr double better_by = 1e-12;
    const PulseBest& better =
        by_nlopt.cost < along.cost - better_by * std::abs(along.cost) ? by_nlopt : along;
    if (better.f && better.cost < least) {
      least = better.cost;
      best = PulseOptimum{{region.with_best_delta(task.island, *better.f), {}}, whole};
    }
  }
  if (best) {
    record.wall_time_s = seconds_now() - started;
    best->found.record = record;
    best->searched = searched_least;
    best->bracketed = bracketed_least;
    best->found.point.tolerance = std::max(best->found.point.tolerance, region.asked());
  }
  return best;
}

}  // namespace stillpoint::design
