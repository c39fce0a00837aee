// SPDX-License-Identifier: MIT
#include <stillpoint/design/trade_off.hpp>

#include "way/room.hpp"

#include <stillpoint/core/free_motion.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/design/figures.hpp>
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

/// The damper with that f and the most tolerance, or the middle of those; empty if none is
/// admissible with the tolerance asked for.
std::optional<DesignPoint> best_with(const Problem& problem, const Limits& limits, double f) {
  std::optional<DesignPoint> best;
  for_each_way(problem, limits, [&](const Way& way) {
    // No damper of the n-th arrival, and so none of a later one, has a tolerance of 1/(2n - 1).
    if (best && way.plain && best->tolerance * (2 * way.n - 1) >= 1) {
      return false;
    }
    Way widest = way;
    widest.limits.tolerance = std::max(0.0, tolerance_at(way, way.scaled(f)));
    const double delta = best_delta(widest, f, BestDelta::middle);
    const double tolerance = largest_tolerance(way, f, delta).value_or(0);
    if (admissible(way, f, delta) && (!best || tolerance > best->tolerance)) {
      best = {f, delta, tolerance};
    }
    return true;
  });
  return best;
}

/// The f of the dampers that have the tolerance asked for.
std::vector<Interval> feasible_spans(const Problem& problem, const Limits& limits,
                                     const Region& region) {
  std::vector<Interval> spans = feasible_f(strips(problem, limits));
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
  return best_with(problem, limits, f);
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
    const auto damper = again ? std::nullopt : best_with(problem, limits, f);
    if (damper) {
      const Figures motion =
          figures_of(free_response({problem.p, f, damper->delta}, {0, problem.v0}));
      front.push_back({*damper, motion.peak, motion.acceleration, motion.stop_time.value_or(0)});
    }
  }
  return front;
}

}  // namespace stillpoint::design
