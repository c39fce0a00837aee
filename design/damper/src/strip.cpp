// SPDX-License-Identifier: MIT
#include "strip.hpp"

#include "nearest_fit.hpp"
#include "way.hpp"

#include <stillpoint/core/input_error.hpp>
#include <stillpoint/core/oscillator.hpp>
#include <stillpoint/design/region.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace stillpoint::design {

namespace {

using Wide = long double;
using unit::Ends;

/// How far inside of its edges a design stays, as in settle.cpp.
constexpr double strip_inset = 1e-9;

double least_double_from(Wide value) {
  const auto nearest = static_cast<double>(value);
  return nearest < value ? std::nextafter(nearest, HUGE_VAL) : nearest;
}

/// In speeds: phi = f/p, d = 2 Delta.
struct Notch {
  Wide phi;
  Wide d;

  [[nodiscard]] Wide before(Wide radius) const { return 2 * phi + std::sqrt(radius * radius + d); }
  [[nodiscard]] double speed(Wide radius) const {
    return least_double_from(std::sqrt((radius - phi) * (radius + phi)));
  }
  [[nodiscard]] Wide before_all(Wide radius, std::int64_t steps) const {
    for (std::int64_t i = 0; i < steps; ++i) {
      radius = before(radius);
    }
    return radius;
  }
};

Notch notch_of(const Problem& problem, double f, double delta) {
  return {f / Wide(problem.p), 2 * Wide(delta)};
}

double stop_start(const Problem& problem) {
  return problem.criterion == Criterion::published ? 0 : 1;
}

/// The tolerance that f alone allows.
double tolerance_of_f(const StripTask& task, double f) {
  const double floor = task.edge.f2 > 0 ? (f - task.edge.f2) / f : 1;
  const double cap = task.f_of(task.a_cap);
  return f > 0 ? std::clamp(std::min(floor, (cap - f) / f), 0.0, 1.0) : 1.0;
}

StripTask with_box(StripTask task, double tolerance) {
  task.limits.tolerance = tolerance;
  return task;
}

}  // namespace

Problem strongest_hit(Problem problem) {
  problem.v0_low = problem.p_high = problem.residual = std::nullopt;
  problem.criterion = Criterion::exact;
  return problem;
}

Problem with_one_arrival(Problem problem) {
  problem.arrivals = 1;
  return problem;
}

PassingSpeeds passing_speeds(const Problem& problem, int n, double f, double delta) {
  const Notch notch = notch_of(problem, f, delta);
  return {notch.speed(notch.before_all(3 * notch.phi, n - 1)),
          notch.speed(notch.before_all(stop_start(problem) * notch.phi, n))};
}

StripTask::StripTask(const Problem& what, const Limits& allowed, int arrival)
    : problem(what),
      limits(allowed),
      n(arrival),
      edge(edges(what, allowed)),
      a2(scaled(edge.f2)),
      a_cap(std::min(scaled(edge.f_cap), unit::strip_tip(n))),
      d_cap(limits.delta_max ? *limits.delta_max / problem.v0 / problem.v0 : HUGE_VAL) {}

bool admissible(const StripTask& task, double f, double delta) {
  const auto& [problem, limits, n, edge, a2, a_cap, d_cap] = task;
  const double low = 1 - limits.tolerance;
  const double high = 1 + limits.tolerance;
  if (!(f * low >= edge.f2 && f * high <= edge.f_cap) ||
      (limits.delta_max && !(delta * high <= *limits.delta_max))) {
    return false;
  }
  // Without constant friction the strips touch, and a box may lie in several.
  const bool all = f == 0;
  const int last = all ? static_cast<int>(problem.arrivals) : n;
  return problem.v0 >= passing_speeds(problem, all ? 2 : n, f * high, delta * high).reach &&
         problem.v0 < passing_speeds(problem, last, f * low, delta * low).pass;
}

std::optional<double> largest_tolerance(const StripTask& task, double f, double delta) {
  const auto fits = [&](double tolerance) {
    return admissible(with_box(task, tolerance), f, delta);
  };
  if (!fits(0)) {
    return std::nullopt;
  }
  if (f == 0) {
    return nearest_fit(std::nextafter(1.0, 0.0), 0, fits);
  }
  double tolerance =
      std::min({tolerance_of_f(task, f),
                unit::strip_tolerance(task.problem.criterion, task.n, task.scaled(f),
                                      delta / task.problem.v0 / task.problem.v0),
                task.limits.delta_max ? (*task.limits.delta_max - delta) / delta : 1});
  // The root is off by a few roundings for each arrival; steps that double bring the box in.
  tolerance = std::max(tolerance, 0.0);
  for (double step = std::numeric_limits<double>::epsilon(); tolerance > 0 && !fits(tolerance);
       step *= 2) {
    tolerance = std::max(0.0, tolerance - step);
  }
  const double asked = task.limits.tolerance;
  return tolerance < asked && fits(asked) ? asked : tolerance;
}

namespace {

/// What feasible_f gives, and the f of the centre where the two edges meet.
struct WholeInterval {
  Ends ends;
  double closing;
};

std::optional<WholeInterval> whole_interval(const StripTask& task) {
  const double tolerance = task.limits.tolerance;
  const auto corners = unit::high_corners(task.problem.criterion, task.n, tolerance, task.d_cap);
  if (!corners) {
    return std::nullopt;
  }
  const double low =
      std::max(lowest_centre(task.edge.f2, tolerance), task.f_of(corners->low / (1 + tolerance)));
  const double closing = highest_centre(task.f_of(corners->high), tolerance);
  const double high = std::min(closing, highest_centre(task.edge.f_cap, tolerance));
  return low <= high ? std::optional(WholeInterval{{low, high}, closing}) : std::nullopt;
}

}  // namespace

std::optional<Ends> feasible_f(const StripTask& task) {
  const auto whole = whole_interval(task);
  return whole ? std::optional(whole->ends) : std::nullopt;
}

std::optional<Ends> design_f(const StripTask& task) {
  const auto whole = whole_interval(task);
  if (!whole) {
    return std::nullopt;
  }
  const auto& [all, closing] = *whole;
  const double high = std::min(all.high, closing * (1 - strip_inset));
  const double least = std::min(high / 2, strip_inset * task.problem.v0 * task.problem.p);
  const Ends inside{std::max(all.low * (1 + strip_inset), least), high};
  return inside.low <= inside.high ? inside : all;
}

DesignPoint with_best_delta(const StripTask& task, double f, bool least) {
  const double a = task.scaled(f);
  const double square = task.problem.v0 * task.problem.v0;
  const auto range = [&](double tolerance) {
    return unit::centre_range(task.problem.criterion, task.n, tolerance, task.d_cap, a);
  };
  // The room for Delta falls as the box grows.
  double box = least ? task.limits.tolerance : tolerance_of_f(task, f);
  if (!least && !range(box)) {
    double fits = 0;
    constexpr double resolved = 1e-15;
    const double most = 1.0 / (2 * task.n - 1);
    for (double wrong = std::min(box, most); wrong - fits > resolved;) {
      const double middle = fits + (wrong - fits) / 2;
      (range(middle) ? fits : wrong) = middle;
    }
    box = fits;
  }
  const Ends ends = range(box).value_or(Ends{0, 0});
  const double d = least ? std::min(ends.low * (1 + strip_inset), ends.high)
                         : ends.low + (ends.high - ends.low) / 2;
  const double delta = d * square;
  return {f, delta, largest_tolerance(task, f, delta).value_or(0)};
}

namespace {

/// Even the largest friction whose box fits below the caps lets the mass pass.
bool always_passes(const StripTask& task) {
  const double k = (1 - task.limits.tolerance) / (1 + task.limits.tolerance);
  const double d = std::min(task.d_cap, 0.5 / (task.n - 1));
  constexpr double rounding = 1e-9;
  return unit::stop_edge(task.problem.criterion, task.n, k * std::max(0.0, task.a_cap), k * d)
             .square < 1 - rounding;
}

}  // namespace

std::optional<StripPoint> any_point(const StripTask& task) {
  if (always_passes(task)) {
    return std::nullopt;
  }
  const auto interval = design_f(task);
  if (!interval) {
    return std::nullopt;
  }
  // A limit of Delta makes the box widest where that meets the reach edge, else the least f does.
  double widest = interval->low;
  if (task.limits.delta_max) {
    const double high = 1 + task.limits.tolerance;
    widest = nearest_fit(interval->high, interval->low, [&](double f) {
               return unit::reach_edge(task.n, task.scaled(f * high), task.d_cap).square <= 1;
             }).value_or(interval->low);
  }
  for (const double f : {widest, interval->low, interval->high}) {
    const auto range = unit::centre_range(task.problem.criterion, task.n, task.limits.tolerance,
                                          task.d_cap, task.scaled(f));
    if (range) {
      const double delta =
          (range->low + (range->high - range->low) / 2) * task.problem.v0 * task.problem.v0;
      if (admissible(task, f, delta)) {
        return StripPoint{f, delta};
      }
    }
  }
  return std::nullopt;
}

double largest_tolerance(const StripTask& task) {
  constexpr double resolved = 1e-12;  // absolute; more than any figure that is read from it
  constexpr double nearly = 1e-8;     // where nothing but (51) binds, a design is so near to it
  const double most = 1.0 / (2 * task.n - 1);
  double fits = any_point(with_box(task, most * (1 - nearly))) ? most * (1 - nearly) : 0;
  for (double wrong = most; wrong - fits > resolved;) {
    const double middle = fits + (wrong - fits) / 2;
    (any_point(with_box(task, middle)) ? fits : wrong) = middle;
  }
  return fits;
}

DecidingArrival deciding_arrival(const Problem& problem, double f, double delta) {
  const auto first = constraints(with_one_arrival(problem), f, delta);
  const auto met = [&](std::string_view name) {
    return std::ranges::find(first, name, &Constraint::name)->satisfied;
  };
  const bool reached = met("start") && met("return");
  if (!reached || met("stop")) {
    return {1, reached};
  }
  const Notch notch = notch_of(problem, f, delta);
  Wide reach = 3 * notch.phi;
  Wide pass = notch.before(stop_start(problem) * notch.phi);
  for (int n = 2; n <= problem.arrivals; ++n) {
    reach = notch.before(reach);
    pass = notch.before(pass);
    if (problem.v0 < notch.speed(reach)) {
      return {n, false};
    }
    if (problem.v0 < notch.speed(pass)) {
      return {n, true};
    }
  }
  return {static_cast<int>(problem.arrivals), false};
}

std::optional<std::int64_t> arrival_of(const Problem& problem, double f, double delta) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  require_within("delta", delta, 0, largest_square);
  // Of ranges, that of the motion shown; in a way that is admissible the model itself decides.
  Problem shown = is_plain(problem, {}) ? problem : strongest_hit(problem);
  const auto [n, stops] = deciding_arrival(shown, f, delta);
  return stops ? std::optional<std::int64_t>(n) : std::nullopt;
}

std::optional<DeltaRange> delta_range(const Problem& problem, std::int64_t arrival, double f) {
  require_valid(problem);
  require_within("f", f, 0, largest_square);
  const double square = problem.v0 * problem.v0;
  if (!is_plain(problem, {})) {
    const auto range = centre_range(Way(problem, {}, static_cast<int>(arrival)), f);
    return range ? std::optional(DeltaRange{range->low * square, range->high * square})
                 : std::nullopt;
  }
  if (arrival == 1) {
    const double low = std::max(0.0, delta1(problem, f));
    return f <= edges(problem, {}).f3 ? std::optional(DeltaRange{low, square / 2}) : std::nullopt;
  }
  const auto range = unit::centre_range(problem.criterion, static_cast<int>(arrival), 0, HUGE_VAL,
                                        f / problem.p / problem.v0);
  return range ? std::optional(DeltaRange{range->low * square, range->high * square})
               : std::nullopt;
}

std::vector<Strip> strips(const Problem& problem, const Limits& limits) {
  require_valid(problem, limits);
  std::vector<Strip> list;
  if (!is_plain(problem, limits)) {
    for_each_way(problem, limits, [&](const Way& way) {
      if (const double largest = largest_tolerance(way); largest > 0) {
        const auto ends = feasible_f(way);
        list.push_back({way.n, least_beta(way), ends ? std::optional(ends->low) : std::nullopt,
                        ends ? std::optional(ends->high) : std::nullopt, largest});
      }
      return true;
    });
    return list;
  }
  const auto beta_min = [&](int n) { return problem.v0 / problem.p * std::sqrt(n / (n + 1.0)); };
  const Problem paper = with_one_arrival(problem);
  Limits any = limits;
  any.tolerance = 0;
  if (admissible_region(paper, any).feasible) {
    const Region region = admissible_region(paper, limits);
    const auto fits = [&](double tolerance) {
      Limits box = limits;
      box.tolerance = tolerance;
      return admissible_region(paper, box).feasible;
    };
    list.push_back({1, beta_min(1), region.f_lower, region.f_upper,
                    nearest_fit(std::nextafter(1.0, 0.0), 0, fits).value_or(0)});
  }
  for_each_strip(problem, any, [&](const StripTask& task) {
    if (any_point(task)) {
      const StripTask asked = with_box(task, limits.tolerance);
      const auto ends = any_point(asked) ? feasible_f(asked) : std::nullopt;
      list.push_back({task.n, beta_min(task.n), ends ? std::optional(ends->low) : std::nullopt,
                      ends ? std::optional(ends->high) : std::nullopt, largest_tolerance(task)});
    }
    return true;
  });
  return list;
}

}  // namespace stillpoint::design
