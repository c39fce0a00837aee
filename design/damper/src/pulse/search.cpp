// SPDX-License-Identifier: MIT
// The best f of a pulse's islands, in two ways. NLopt searches f, and the tolerance for `robust`;
// Delta follows from both. Beside it stands the optimum along f alone: the largest box by its
// edges, the other objectives by sampling and Brent's method. docs/theory.md section 8.

#include "pulse/search.hpp"

#include "search/nlopt_fence.hpp"
#include "search/run.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace stillpoint::design {

namespace {

/// One island, kept a relative 1e-9 from its edges where it is wide enough: an edge is a graze, or
/// a peak that is beta to the last digit.
struct PulseTask {
  const PulseRegion& region;
  Objective objective;
  Island island;

  PulseTask(const PulseRegion& of, Objective what, const Island& whole)
      : region(of), objective(what), island(whole) {
    constexpr double inset = 1e-9;
    const Island inner{whole.low * (1 + inset), whole.high * (1 - inset)};
    if (inner.low < inner.high && region.box_in(inner, region.asked())) {
      island = inner;
    }
  }

  [[nodiscard]] double cost(double f) const {
    switch (objective) {
      case Objective::robust:
        return -region.with_best_delta(island, f).tolerance;
      case Objective::amplitude:
        return region.at(f).peak;
      case Objective::time:
        return region.at(f).time;
      case Objective::acceleration:
        break;
    }
    return region.at(f).acceleration;
  }
  /// The tolerance asked for is there.
  [[nodiscard]] bool fits(double f) const {
    const double tolerance = region.asked();
    const double low = f * (1 - tolerance);
    const double high = f * (1 + tolerance);
    constexpr double rounding = 1e-14;
    return low >= island.low * (1 - rounding) && high <= island.high * (1 + rounding) &&
           region.use_of_delta(std::max(low, island.low), std::min(high, island.high), tolerance) <=
               1;
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
  const auto fits = [&](double tolerance) { return region.box_in(island, tolerance).has_value(); };
  const double by_edges = (island.high - island.low) / (island.high + island.low);
  const double most = std::min(by_edges, std::max(widest_tolerance, region.asked()));
  constexpr double rounding = 1e-15;
  double tolerance = std::max(region.asked(), most * (1 - rounding));
  if (tolerance > region.asked() && !fits(tolerance)) {
    tolerance = last_that_holds(region.asked(), tolerance, fits);
  }
  return region.box_in(island, tolerance).value_or(island.low) / (1 - tolerance);
}

PulseBest bracketed(const PulseTask& task) {
  PulseBest best;
  const double tolerance = task.region.asked();
  const double low = task.island.low / (1 - tolerance);
  const double high = task.island.high / (1 + tolerance);
  if (const auto box = task.region.box_in(task.island, tolerance)) {
    best.consider(task, *box / (1 - tolerance));
  }
  if (task.objective == Objective::robust) {
    best.consider(task, middle_of_largest_box(task));
    return best;
  }
  constexpr int steps = 64;
  double before = low;
  bool fitted = task.fits(low);
  best.consider(task, low);
  for (int i = 1; i <= steps; ++i) {
    const double now =
        i == steps ? high : low * std::pow(high / low, static_cast<double>(i) / steps);
    const bool fits = task.fits(now);
    best.consider(task, now);
    if (fits != fitted) {  // the end of what delta_max leaves
      best.consider(task, last_that_holds(fits ? now : before, fits ? before : now,
                                          [&](double f) { return task.fits(f); }));
    }
    before = now;
    fitted = fits;
  }
  if (best.f) {
    constexpr int bits = 30;
    const double step = std::pow(high / low, 1.0 / steps);
    best.consider(task, boost::math::tools::brent_find_minima(
                            [&](double f) { return task.cost(f); }, std::max(low, *best.f / step),
                            std::min(high, *best.f * step), bits)
                            .first);
  }
  return best;
}

/// The best f of the samples, a start for NLopt; the middle for `robust`, or where none fits.
double start_of(const PulseTask& task) {
  PulseBest best;
  if (task.objective != Objective::robust) {
    for (const FirstReturn& now : task.region.profile()->samples()) {
      if (task.island.low <= now.f && now.f <= task.island.high) {
        best.consider(task, now.f);
      }
    }
  }
  return best.f.value_or(std::sqrt(task.island.low) * std::sqrt(task.island.high));
}

/// By differences, one-sided at a bound of f.
template <class Value>
double slope(const Value& value, double at, const Island& within) {
  constexpr double part = 1e-7;
  const double low = std::max(within.low, at * (1 - part));
  const double high = std::min(within.high, at * (1 + part));
  return high > low ? (value(high) - value(low)) / (high - low) : 0;
}

/// x = f / high of the island and, for `robust`, t: the least -t or cost with
///   low / high - x (1 - t) <= 0,  x (1 + t) - 1 <= 0,  need (1 + t) / ((1 - t) delta_max) - 1 <=
///   0.
NloptProblem constrained(const PulseTask& task, double scale,
                         const std::function<void(double)>& visit) {
  const double high = task.island.high;
  const double low = task.island.low;
  const bool robust = task.objective == Objective::robust;
  const double asked = task.region.asked();
  const double most = std::max(widest_tolerance, asked);
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
    store(gradient, -(1 - box(x)), x[0]);
    return low / high - x[0] * (1 - box(x));
  });
  posed.constraints.emplace_back([=](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    store(gradient, 1 + box(x), x[0]);
    return x[0] * (1 + box(x)) - 1;
  });
  const auto use = [=, &task](double f, double t) {
    const double box_low = std::clamp(f * (1 - t), low, high);
    return task.region.use_of_delta(box_low, std::clamp(f * (1 + t), box_low, high), t) - 1;
  };
  posed.constraints.emplace_back([=, &task](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) {
    const double f = x[0] * high;
    const double t = box(x);
    if (gradient.size() > 0) {
      const auto by_f = [&](double now) { return use(now, t); };
      const auto by_t = [&](double now) { return use(f, now); };
      store(gradient, slope(by_f, f, task.island) * high,
            t > 0 ? slope(by_t, t, {0, most}) : (by_t(1e-7) - by_t(0)) / 1e-7);
    }
    return use(f, t);
  });
  return posed;
}

/// For algorithms that know only bounds: what does not fit costs more than all that does.
NloptProblem penalised(const PulseTask& task, double scale,
                       const std::function<void(double)>& visit) {
  const double asked = task.region.asked();
  NloptProblem posed;
  posed.lower = Eigen::VectorXd::Constant(1, task.island.low / (1 - asked));
  posed.upper = Eigen::VectorXd::Constant(1, task.island.high / (1 + asked));
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
                        : worse + task.region.use_of_delta(f * (1 - asked), f * (1 + asked), asked);
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
  const NloptOutcome outcome = run(posed, algorithm.name, options, [&]() -> Eigen::VectorXd {
    return best.f ? Eigen::VectorXd::Constant(
                        1, *best.f / (task.island.high / (1 + task.region.asked())))
                  : posed.start;
  });
  best.consider(task, outcome.x[0] * (takes_constraints
                                          ? task.island.high
                                          : std::max(task.island.high / (1 + task.region.asked()),
                                                     task.island.low / (1 - task.region.asked()))));
  record.algorithm = algorithm.name;
  record.status = outcome.status;
  record.evaluations += outcome.evaluations;
  return best;
}

}  // namespace

std::optional<PulseOptimum> search(const PulseRegion& region, const SearchOptions& options) {
  const auto started = std::chrono::steady_clock::now();
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
    // Of equal tolerances the one along f has the largest f, and so the least peak and Delta.
    constexpr double better_by = 1e-12;
    const PulseBest& better =
        by_nlopt.cost < along.cost - better_by * std::abs(along.cost) ? by_nlopt : along;
    if (better.f && better.cost < least) {
      least = better.cost;
      best = PulseOptimum{{region.with_best_delta(task.island, *better.f), {}}, whole};
    }
  }
  if (best) {
    record.wall_time_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    best->found.record = record;
    best->searched = searched_least;
    best->bracketed = bracketed_least;
    best->found.point.tolerance = std::max(best->found.point.tolerance, region.asked());
  }
  return best;
}

}  // namespace stillpoint::design
