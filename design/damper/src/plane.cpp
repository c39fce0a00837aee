// SPDX-License-Identifier: MIT
#include <stillpoint/design/limit_kinds.hpp>
#include <stillpoint/design/plane.hpp>
#include <stillpoint/design/strips.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr int grid_parts = 200;  // of an axis

struct Span {
  PlaneKind kind{PlaneKind::arrival};
  std::int64_t arrival{0};
  Interval delta{};
};
using Spans = std::vector<Span>;

bool is_alike(const Spans& one, const Spans& other) {
  return std::equal(
      one.begin(), one.end(), other.begin(), other.end(),
      [](const Span& a, const Span& b) { return a.kind == b.kind && a.arrival == b.arrival; });
}

/// The f closest to `outside` at which something still holds that holds at `inside`.
template <class Holds>
double last_inside(double inside, double outside, const Holds& holds) {
  constexpr int halvings = 25;  // far below a pixel
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(inside, outside);
    (holds(middle) ? inside : outside) = middle;
  }
  return inside;
}

/// Continues the areas that end at f = `before`.
void add_column(std::vector<PlaneArea>& areas, double before, double f, const Spans& spans) {
  for (const Span& span : spans) {
    auto area = std::ranges::find_if(areas, [&](const PlaneArea& each) {
      return each.kind == span.kind && each.arrival == span.arrival &&
             each.columns.back().f == before;
    });
    auto& columns = area == areas.end()
                        ? areas.emplace_back(PlaneArea{span.kind, span.arrival}).columns
                        : area->columns;
    const auto is_level = [&](const PlaneArea::Column& column) {
      return column.delta.low == span.delta.low && column.delta.high == span.delta.high;
    };
    const std::size_t count = columns.size();
    if (count > 1 && is_level(columns[count - 1]) && is_level(columns[count - 2])) {
      columns.back().f = f;
    } else {
      columns.push_back({f, span.delta});
    }
  }
}

/// Of the spans over f, which are ordered alike, also where areas begin or end between the f given.
template <class SpansOf>
std::vector<PlaneArea> areas_over(const std::vector<double>& grid, const SpansOf& spans_of) {
  std::vector<PlaneArea> areas;
  Spans last;
  double before = HUGE_VAL;
  const auto add = [&](double f, Spans spans) {
    add_column(areas, before, f, spans);
    before = f;
    last = std::move(spans);
  };
  for (const double f : grid) {
    Spans now = spans_of(f);
    constexpr int most_edges = 50;
    double from = before;
    for (int i = 0; from < f && !is_alike(last, now) && i < most_edges; ++i) {
      const double edge =
          last_inside(from, f, [&](double at) { return is_alike(last, spans_of(at)); });
      const double beyond = edge + (f - from) * 1e-7;
      from = edge < beyond && beyond < f ? beyond : f;
      add(edge, spans_of(edge));
      add(edge, spans_of(from));
    }
    add(f, std::move(now));
  }
  std::erase_if(areas, [](const PlaneArea& area) { return area.columns.size() < 2; });
  std::ranges::stable_sort(
      areas, {}, [](const PlaneArea& area) { return std::pair(area.kind, area.arrival); });
  return areas;
}

void add_even(std::vector<double>& grid, const Interval& f) {
  for (int i = 0; f.low <= f.high && i <= grid_parts; ++i) {
    grid.push_back(f.low + (f.high - f.low) * i / grid_parts);
  }
}

/// One area over an interval of f.
template <class RangeOf>
void add_strip(std::vector<PlaneArea>& areas, PlaneKind kind, std::int64_t arrival,
               const Interval& f, const RangeOf& range_of) {
  std::vector<double> grid;
  add_even(grid, f);
  std::ranges::move(
      areas_over(
          grid,
          [&](double at) {
            const std::optional<Interval> delta = range_of(at);
            return delta && delta->low <= delta->high ? Spans{{kind, arrival, *delta}} : Spans{};
          }),
      std::back_inserter(areas));
}

/// Calls visit(arrival, f) for each strip up to an arrival. Where any rest is within the residual,
/// whatever the arrival, there are no others.
template <class Visit>
void for_each_strip(const Problem& problem, const Limits& limits, std::int64_t most,
                    const Visit& visit) {
  const std::vector<Strip> all = strips(problem, limits);
  double rest_end = 0;
  for (const Strip& strip : all) {
    if (strip.arrival == 0 && !strip.at_peak) {
      rest_end = strip.f_upper.value_or(0);
    }
  }
  for (const auto& [n, beta, low, high, tolerance, at_peak] : all) {
    if (low && n <= most) {
      visit(n, Interval{n > 0 ? std::max(*low, rest_end) : *low, *high});
    }
  }
}

/// Even ones, and both sides of each edge, the middle between two of them too.
std::vector<double> grid_of(const Interval& f, std::vector<double> edges) {
  edges.push_back(f.low);
  edges.push_back(f.high);
  std::erase_if(edges, [&](double edge) { return !(f.low <= edge && edge <= f.high); });
  std::ranges::sort(edges);
  std::vector<double> grid;
  add_even(grid, f);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    grid.push_back(std::max(std::nextafter(edges[i], -HUGE_VAL), f.low));
    grid.push_back(edges[i]);
    grid.push_back(std::min(std::nextafter(edges[i], HUGE_VAL), f.high));
    grid.push_back(std::midpoint(edges[i], edges[i > 0 ? i - 1 : 0]));
  }
  std::ranges::sort(grid);
  grid.erase(std::unique(grid.begin(), grid.end()), grid.end());
  return grid;
}

/// Adds what can be seen of a span in the window.
void add_seen(Spans& spans, const PlaneWindow& window, PlaneKind kind, std::int64_t arrival,
              Interval delta) {
  constexpr double visible = 1e-4;  // of the axis
  const auto& [low, high] = window.delta;
  delta = {std::clamp(delta.low, low, high), std::clamp(delta.high, low, high)};
  if (delta.high - delta.low > visible * (high - low)) {
    spans.push_back({kind, arrival, delta});
  }
}

/// How Delta decides at one f that the peak allows and with which the mass can come back.
struct Column {
  double stop;  ///< below it the mass passes the last arrival allowed
  /// The strips by arrival, from 0, any rest within the residual. Those of arrivals beyond the ones
  /// that are shown are one.
  std::vector<std::optional<Interval>> strips;
};

Column column_at(const Problem& problem, double f) {
  Column column{least_stopping_delta(problem, f), {}};
  const std::int64_t last = std::min(problem.arrivals, most_shown_strips + 1);
  for (std::int64_t n = 0; n <= last; ++n) {
    // Every hit up to V0 needs the first arrival.
    const bool exists = n == 0 ? problem.residual.has_value() : n == 1 || problem.v0_low != 0.0;
    auto range = exists ? delta_range(problem, n, f) : std::nullopt;
    if (range && n > most_shown_strips) {
      range->low = column.stop;
    }
    column.strips.push_back(range);
  }
  return column;
}

/// Where the mass rests off centre or beyond the residual: from the next lower strip, or the stop,
/// to that of arrival n; n = 0: up to the start. Empty if there is no such strip or nothing
/// between.
std::optional<Interval> below_strip(const Column& column, std::size_t n) {
  const auto& strips = column.strips;
  // Strip 1 begins at the start, so that nothing is above it.
  if (strips[0] || (n == 0 ? strips[1].has_value() : !strips[n])) {
    return std::nullopt;
  }
  Interval range{column.stop, n == 0 ? HUGE_VAL : strips[n]->low};
  for (std::size_t below = n + 1; below < strips.size(); ++below) {
    range.low = strips[below] ? std::max(range.low, strips[below]->high) : range.low;
  }
  return range;
}

/// Where only Delta decides: `at` is what the motion does, `asked` what the criterion admits.
void add_decided_by_delta(Spans& spans, const PlaneWindow& window, const Column& at,
                          const Column& asked, double top, double start) {
  using enum PlaneKind;
  const auto add = [&](PlaneKind kind, std::int64_t n, double low, double high) {
    add_seen(spans, window, kind, n, {low, high});
  };
  add(notch_too_weak, 0, 0, std::min(at.stop, top));
  add(above_delta_max, 0, std::max(at.stop, top), start);
  add(notch_too_weak_and_limited, 0, top, std::min(at.stop, start));
  for (std::size_t n = 0; n < at.strips.size(); ++n) {
    const auto number = static_cast<std::int64_t>(n);
    const auto& strip = at.strips[n];
    if (strip && (n == 0 || !at.strips[0])) {
      const double admitted = asked.strips[n] ? asked.strips[n]->low : HUGE_VAL;
      add(by_criterion_alone, number, strip->low, std::min({strip->high, admitted, top}));
    }
    if (const auto span = below_strip(at, n)) {
      add(off_centre, number, span->low, std::min(span->high, top));
    }
  }
}

}  // namespace

std::optional<Interval> PlaneArea::at(double f) const {
  const auto next = std::ranges::lower_bound(columns, f, {}, &Column::f);
  if (next == columns.end() || f < columns.front().f) {
    return std::nullopt;
  }
  const Column& before = next == columns.begin() ? *next : *std::prev(next);
  const double part = next->f > before.f ? (f - before.f) / (next->f - before.f) : 0;
  return Interval{std::lerp(before.delta.low, next->delta.low, part),
                  std::lerp(before.delta.high, next->delta.high, part)};
}

std::vector<PlaneArea> admissible_areas(const Problem& problem, const Limits& limits,
                                        std::int64_t last) {
  using enum PlaneKind;
  Limits no_box = limits;
  no_box.tolerance = 0;
  const double cap = largest_delta_allowed(limits);
  std::vector<PlaneArea> areas;
  for_each_strip(problem, no_box, most_shown_strips + 1, [&](std::int64_t n, const Interval& f) {
    const bool later = n > most_shown_strips && problem.arrivals > n;
    add_strip(areas,
              later    ? later_arrivals
              : n == 0 ? any_rest
                       : arrival,
              n, f, [&](double at) {
                auto range = delta_range(problem, n, at);
                if (range) {
                  range = {later ? least_stopping_delta(problem, at) : range->low,
                           std::min(range->high, cap)};
                }
                return range;
              });
  });
  std::ranges::stable_sort(areas, {}, [last](const PlaneArea& area) {
    return area.arrival > 0 && area.arrival == last ? most_arrivals + 1 : area.arrival;
  });
  return areas;
}

std::vector<PlaneArea> tolerant_areas(const Problem& problem, const Limits& limits) {
  std::vector<PlaneArea> areas;
  if (limits.tolerance > 0) {
    for_each_strip(problem, limits, most_shown_strips, [&](std::int64_t n, const Interval& f) {
      add_strip(areas, PlaneKind::arrival, n, f,
                [&](double at) { return feasible_delta(problem, limits, n, at); });
    });
  }
  return areas;
}

std::vector<PlaneArea> forbidden_areas(const Problem& problem, const Limits& limits,
                                       const Region& region, const PlaneWindow& window) {
  using enum PlaneKind;
  const double first = std::max(region.f2, 0.0);
  const double start = region.delta2.value();
  const double top = std::min(start, largest_delta_allowed(limits));
  const double allowed = largest_f_allowed(problem, limits);
  const double largest = largest_stopping_f(problem);
  const double strong = dead_zone_binds(problem) ? region.f1 : largest;
  // From there on friction could hold the mass at the limit.
  const double held = problem.residual      ? std::max(strong, region.f1)
                      : largest < region.f1 ? HUGE_VAL
                                            : region.f1;
  Problem exact = problem;  // what the motion does
  exact.criterion = Criterion::exact;
  return areas_over(grid_of(window.f, {first, strong, held, allowed}), [&](double f) {
    Spans spans;
    if (first <= f && f <= std::min(strong, allowed)) {
      const Column at = column_at(exact, f);
      add_decided_by_delta(spans, window, at,
                           problem.criterion == Criterion::exact ? at : column_at(problem, f), top,
                           start);
    } else {
      add_seen(spans, window,
               f < std::min(first, strong) ? (f > allowed ? too_weak_and_limited : too_weak)
               : f < first                 ? too_weak_and_strong
               : f <= strong               ? beyond_limit
               : f <= held                 ? too_strong
                                           : dead_zone,
               0, {0, start});
    }
    add_seen(spans, window, held_at_start, 0, {start, HUGE_VAL});
    return spans;
  });
}

std::vector<PlaneArea> pulse_areas(const PulseProblem& problem, const Limits& limits,
                                   const Region& region, const std::vector<Interval>& intervals,
                                   const PlaneWindow& window) {
  using enum PlaneKind;
  PulseProblem motion = problem;  // what it does
  motion.criterion = Criterion::exact;
  const auto asked = least_delta(problem);
  const auto exact = problem.criterion == Criterion::exact ? asked : least_delta(motion);
  const double cap = largest_delta_allowed(limits);
  std::vector<double> edges{region.f3};
  for (const Interval& interval : intervals) {
    edges.push_back(interval.low);
    edges.push_back(interval.high);
  }
  const bool never_in_reach = intervals.empty() && region.beta_min > problem.beta;
  auto areas = areas_over(grid_of(window.f, std::move(edges)), [&](double f) {
    Spans spans;
    const auto add = [&](PlaneKind kind, double low, double high) {
      add_seen(spans, window, kind, 0, {low, high});
    };
    const auto next = std::ranges::find_if(
        intervals, [f](const Interval& interval) { return f <= interval.high; });
    if (next != intervals.end() && next->low <= f) {
      const double stop = exact(f).value_or(0);
      const double least = asked(f).value_or(0);
      add(admissible, least, cap);
      add(notch_too_weak, 0, std::min(stop, cap));
      add(by_criterion_alone, stop, std::min(least, cap));
      add(above_delta_max, cap, HUGE_VAL);
    } else {
      add(next != intervals.end() ? (next == intervals.begin() ? too_weak : misses_limits)
          : f <= region.f3        ? (never_in_reach ? exceeds_everywhere : misses_limits)
          : region.beta_min == 0  ? never_starts
                                  : too_strong,
          0, HUGE_VAL);
    }
    return spans;
  });
  constexpr double visible = 1e-3;  // of the axis
  std::erase_if(areas, [&](const PlaneArea& area) {
    return area.columns.back().f - area.columns.front().f <
           visible * (window.f.high - window.f.low);
  });
  return areas;
}

std::vector<PlaneArea> tolerant_areas(const PulseProblem& problem, const Limits& limits,
                                      const std::vector<Interval>& intervals, double delta_most) {
  std::vector<PlaneArea> areas;
  if (limits.tolerance > 0) {
    const auto feasible = feasible_delta(problem, limits);
    for (const Interval& interval : intervals) {
      add_strip(areas, PlaneKind::admissible, 0, interval, [&](double f) {
        auto delta = feasible(f);
        return delta ? std::optional(Interval{delta->low, std::min(delta->high, delta_most)})
                     : delta;
      });
    }
  }
  return areas;
}

PlaneWindow thickest_part(const PlaneArea& area) {
  const Interval thickest =
      std::ranges::max_element(area.columns, {}, [](const PlaneArea::Column& column) {
        return column.delta.high - column.delta.low;
      })->delta;
  const auto is_within = [&](double at) { return thickest.low <= at && at <= thickest.high; };
  Interval f{HUGE_VAL, -HUGE_VAL};
  for (const auto& [at, delta] : area.columns) {
    if (is_within(delta.low) || is_within(delta.high)) {
      f = {std::min(f.low, at), std::max(f.high, at)};
    }
  }
  return {f, thickest};
}

Interval edges_about(const std::vector<PlaneArea>& areas, double f, double delta) {
  Interval around{-HUGE_VAL, HUGE_VAL};
  for (const PlaneArea& area : areas) {
    const auto range = area.at(f);
    for (const double edge : range ? std::vector{range->low, range->high} : std::vector<double>{}) {
      (edge <= delta ? around.low : around.high) =
          edge <= delta ? std::max(around.low, edge) : std::min(around.high, edge);
    }
  }
  return around;
}

std::string_view beyond_limits(const Problem& problem, const Limits& limits) {
  const double allowed = largest_f_allowed(problem, limits);
  for (const LimitEdge& one : limit_edges(problem, limits)) {
    if (one.kind->bounds_f() && one.edge == allowed) {
      return one.kind->beyond;
    }
  }
  return {};
}

}  // namespace stillpoint::design
