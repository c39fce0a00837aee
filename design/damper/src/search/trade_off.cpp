// SPDX-License-Identifier: MIT
#include <stillpoint/design/trade_off.hpp>

#include "golden_sections.hpp"
#include "region/limit_table.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/region.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>

namespace stillpoint::design {

namespace {

/// The task at one f, as a function of Delta.
struct AtF {
  const Problem& problem;
  const Limits& limits;
  double f;

  /// The tolerance of the damper, or minus the factor by which it misses a constraint. Within a
  /// strip it rises up to where it is largest and falls from there.
  [[nodiscard]] double worth(double delta) const {
    if (const auto tolerance = largest_tolerance(problem, limits, f, delta)) {
      return *tolerance;
    }
    double miss = 0;
    for (const Constraint& now : constraints(problem, limits, f, delta)) {
      if (!now.satisfied) {
        miss = std::max(miss, std::abs(now.slack) / std::max(now.value, now.limit));
      }
    }
    return -miss;
  }

  /// The best Delta of the span; if only f binds, the middle of those that are equally good.
  [[nodiscard]] double best_in(const Interval& span) const {
    const auto [low, high] = span;
    int rounds = 75;  // phi^-75 = 2e-16
    const double best = golden_sections(
        span, [this](double delta) { return worth(delta); },
        [&rounds](const Interval&, double, double) { return rounds-- == 0; });
    const double most = worth(best);
    // Far above the rounding of a tolerance, far below what can be built.
    constexpr double equal = 1e-12;
    constexpr int bisections = 20;  // which of several equal Delta is taken need not be exact
    const auto end_towards = [&](double out) {
      double in = best;
      for (int i = 0; i < bisections; ++i) {
        const double now = std::midpoint(in, out);
        (worth(now) >= most - equal ? in : out) = now;
      }
      return in;
    };
    const double middle = std::midpoint(end_towards(low), end_towards(high));
    return worth(middle) >= most - equal ? middle : best;
  }
};

/// The best damper with that f; empty if none is admissible with the tolerance asked for.
std::optional<DesignPoint> best_with(const AtF& task) {
  const Problem& problem = task.problem;
  std::optional<DesignPoint> best;
  const auto consider = [&](double low, double high) {
    cancellation_point();
    high = std::min(high, least_limit(Bounded::delta, task.limits));
    const double delta = low < high ? task.best_in({low, high}) : high;
    if (admissible(task.problem, task.limits, task.f, delta)) {
      const double tolerance =
          largest_tolerance(task.problem, task.limits, task.f, delta).value_or(0);
      if (!best || tolerance > best->tolerance) {
        best = {task.f, delta, tolerance};
      }
    }
  };
  consider(0, problem.v0 * problem.v0 / 2);
  for (std::int64_t n = 1; problem.arrivals > 1 && n <= problem.arrivals; ++n) {
    // No damper of the n-th arrival, and so none of a later one, has a tolerance of 1/(2n - 1).
    if (best && n > 1 && best->tolerance * static_cast<double>(2 * n - 1) >= 1) {
      break;
    }
    if (const auto range = delta_range(problem, n, task.f)) {
      consider(range->low, range->high);
    }
  }
  return best;
}

/// The f of the dampers that have the tolerance asked for.
std::vector<Interval> feasible_spans(const Problem& problem, const Limits& limits,
                                     const Region& region) {
  std::vector<Interval> strip_spans;
  for (const Strip& strip : strips(problem, limits)) {
    if (strip.f_lower) {
      strip_spans.push_back({*strip.f_lower, *strip.f_upper});
    }
  }
  std::ranges::sort(strip_spans, {}, &Interval::low);
  std::vector<Interval> spans;
  for (const Interval& span : strip_spans) {
    if (spans.empty() || spans.back().high < span.low) {
      spans.push_back(span);
    } else {
      spans.back().high = std::max(spans.back().high, span.high);
    }
  }
  if (spans.empty() || spans.front().low != *region.f_lower ||
      spans.back().high != *region.f_upper) {
    spans.assign(1, {*region.f_lower, *region.f_upper});  // the strips are not all there is
  }
  // Like a design, it stays off the edges, which rounding may put on either side.
  constexpr double inset = 1e-9;
  for (auto& [low, high] : spans) {
    const double least = std::max(low, inset * problem.v0 * problem.p);
    const double off = inset * (high - low);
    if (least + off < high - off) {
      low = least + off;
      high -= off;
    }
  }
  return spans;
}

/// The f of the front's damper number `place` of `count`: at equal steps of the widths of all
/// spans.
double f_at(const std::vector<Interval>& spans, std::int64_t place, std::int64_t count) {
  double width = 0;
  for (const Interval& span : spans) {
    width += span.high - span.low;
  }
  double at = width * static_cast<double>(place - 1) / static_cast<double>(count - 1);
  std::size_t k = 0;
  while (k + 1 < spans.size() && at > spans[k].high - spans[k].low) {
    at -= spans[k].high - spans[k].low;
    ++k;
  }
  return std::min(spans[k].low + at, spans[k].high);
}

/// Throws InputError unless least_trade_offs <= count <= most_trade_offs.
void require_trade_offs(std::int64_t count) {
  if (count < least_trade_offs || count > most_trade_offs) {
    throw InputError(
        "trade_off", std::to_string(count),
        fmt::format("must be a whole number from {} to {}", least_trade_offs, most_trade_offs));
  }
}

}  // namespace

std::optional<DesignPoint> trade_off_at(const Problem& problem, const Limits& limits,
                                        std::int64_t count, std::int64_t place) {
  require_trade_offs(count);
  if (place < 1 || place > count) {
    throw InputError("place", std::to_string(place),
                     "must be from 1 to trade_off = " + std::to_string(count));
  }
  const Region region = admissible_region(problem, limits);
  if (!region.feasible) {
    return std::nullopt;
  }
  const double f = f_at(feasible_spans(problem, limits, region), place, count);
  return best_with({problem, limits, f});
}

std::vector<TradeOff> trade_off(const Problem& problem, const Limits& limits, std::int64_t count) {
  require_trade_offs(count);
  const Region region = admissible_region(problem, limits);
  if (!region.feasible) {
    return {};
  }
  const std::vector<Interval> spans = feasible_spans(problem, limits, region);
  std::vector<TradeOff> front;
  for (std::int64_t place = 1; place <= count; ++place) {
    const double f = f_at(spans, place, count);
    const bool again = !front.empty() && front.back().damper.f >= f;
    const auto damper = again ? std::nullopt : best_with({problem, limits, f});
    if (damper) {
      const Response motion = free_response({problem.p, f, damper->delta}, {0, problem.v0});
      front.push_back({*damper, motion.peak_amplitude, motion.peak_absolute_acceleration,
                       motion.stop_time.value_or(0)});
    }
  }
  return front;
}

}  // namespace stillpoint::design
