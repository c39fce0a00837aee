// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"
#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::AreaLook;
using figures::Figure;
using figures::FigureArea;
using figures::FigurePoint;
using figures::Ink;

namespace {

constexpr int strip_steps = 200;          // of an edge over f
constexpr std::int64_t most_strips = 12;  // that can be told apart

/// Of ranges or with a residual: between the ends that the region has for this arrival.
std::vector<FigurePoint> way_outline(const DrawnRegion& drawn, std::int64_t arrival, double unit) {
  design::Limits no_box = drawn.limits;
  no_box.tolerance = 0;
  std::vector<FigurePoint> outline;
  std::vector<FigurePoint> upper;
  for (const design::Strip& strip : design::strips(drawn.problem, no_box)) {
    if (strip.arrival != arrival || !strip.f_lower) {
      continue;
    }
    for (int i = 0; i <= strip_steps; ++i) {
      const double f = *strip.f_lower + (*strip.f_upper - *strip.f_lower) * i / strip_steps;
      const auto range = design::delta_range(drawn.problem, arrival, f);
      const double most = drawn.limits.delta_max.value_or(HUGE_VAL);
      if (range && range->low <= most) {
        outline.push_back({f, range->low * unit});
        upper.push_back({f, std::min(range->high, most) * unit});
      }
    }
  }
  outline.insert(outline.end(), upper.rbegin(), upper.rend());
  return outline;
}

std::vector<FigurePoint> strip_outline(const DrawnRegion& drawn, std::int64_t arrival,
                                       double unit) {
  const auto n = static_cast<double>(arrival);
  if (!is_plain(drawn.problem, {})) {
    return way_outline(drawn, arrival, unit);
  }
  const double tip = drawn.problem.v0 * drawn.problem.p / (2 * std::sqrt(n * (n + 1)));
  const double first = std::max(drawn.region.f2, 0.0);
  const double last =
      std::min({tip, drawn.limits.f_max.value_or(HUGE_VAL), drawn.region.f4.value_or(HUGE_VAL)});
  std::vector<FigurePoint> lower;
  std::vector<FigurePoint> upper;
  for (int i = 0; first <= last && i <= strip_steps; ++i) {
    const double f = first + (last - first) * i / strip_steps;
    const auto range = design::delta_range(drawn.problem, arrival, f);
    const double top = range ? std::min(range->high, drawn.limits.delta_max.value_or(HUGE_VAL)) : 0;
    if (range && range->low <= top) {
      lower.push_back({f, range->low * unit});
      upper.push_back({f, top * unit});
    }
  }
  if (lower.size() < 2) {
    return {};
  }
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  return lower;
}

/// One strip, below which the mass passes x = 0.
bool only_the_first(const design::Problem& problem) {
  return problem.arrivals == 1 && !problem.residual;
}

/// The outline of a strip is its lower edge and then, backwards, the upper one.
void add_below(Figure& figure, const FigureArea& strip) {
  const auto edge = static_cast<std::ptrdiff_t>(strip.outline.size() / 2);
  std::vector<FigurePoint> outline(strip.outline.begin(), strip.outline.begin() + edge);
  outline.push_back({outline.back().x, figure.y.least});
  outline.push_back({outline.front().x, figure.y.least});
  figure.areas.push_back({"notch too weak", std::move(outline), Ink::grey, AreaLook::hatched});
}

/// Neighbours may touch, so they differ, and so do the first three, which may be named in the
/// legend; the damper's own is like any admissible area.
Ink strip_ink(std::int64_t arrival, std::int64_t own) {
  if (arrival == own) {
    return Ink::sky;
  }
  if (arrival == 0) {
    return Ink::amber;
  }
  constexpr std::array inks{Ink::orange, Ink::green, Ink::purple};
  return inks.at(static_cast<std::size_t>(arrival) % inks.size());
}

}  // namespace

std::vector<FigureArea> strip_areas(const DrawnRegion& drawn, const FigureUnits& units) {
  const auto& damper = drawn.damper;
  std::int64_t own = -1;  // that of the damper; 0: any rest
  if (damper) {
    own = design::arrival_of(drawn.problem, damper->f, damper->delta).value_or(0);
    if (own > 0 && strip_outline(drawn, own, units.length).empty()) {
      own = 0;  // it has no strip of its own but rests within the residual
    }
  }
  const bool only_one = only_the_first(drawn.problem);
  if (only_one) {
    own = 1;
  }
  std::vector<FigureArea> areas;
  const auto add = [&](std::int64_t n) {
    if (auto outline = strip_outline(drawn, n, units.length); !outline.empty()) {
      areas.push_back({only_one ? "admissible"
                       : n > 0  ? format("arrival {}", n)
                                : "any rest within the residual",
                       std::move(outline), strip_ink(n, own)});
    }
  };
  if (drawn.problem.residual) {
    add(0);
  }
  for (std::int64_t n = 1; n <= std::min(drawn.problem.arrivals, most_strips); ++n) {
    if (n != own) {
      add(n);
    }
  }
  if (own > 0) {
    add(own);
  }
  return areas;
}

void add_limits(Figure& figure, const DrawnRegion& drawn, const FigureUnits& units) {
  const auto forbid = [&](std::string name, FigurePoint from, FigurePoint to, Ink ink) {
    from = {std::clamp(from.x, figure.x.least, figure.x.most),
            std::clamp(from.y, figure.y.least, figure.y.most)};
    to = {std::clamp(to.x, figure.x.least, figure.x.most),
          std::clamp(to.y, figure.y.least, figure.y.most)};
    constexpr double seen = 1e-3;  // of the axis
    if (to.x - from.x > seen * (figure.x.most - figure.x.least) && from.y < to.y) {
      figure.areas.push_back(
          {std::move(name), {from, {to.x, from.y}, to, {from.x, to.y}}, ink, AreaLook::hatched});
    }
  };
  const double far = HUGE_VAL;
  const double start = drawn.region.delta2.value() * units.length;
  double last = 0;  // f of the strips
  for (const FigureArea& strip : figure.areas) {
    last = std::max(last, std::ranges::max(strip.outline, {}, &FigurePoint::x).x);
  }
  if (only_the_first(drawn.problem) && last > 0) {
    add_below(figure, figure.areas.front());
  }
  const double f4 = drawn.region.f4.value_or(far);
  const double f_max = drawn.limits.f_max.value_or(far);
  forbid("notch holds at the start", {0, start}, {far, far}, Ink::grey);
  forbid("too weak: exceeds " + units.length_words(drawn.problem.beta), {0, 0},
         {drawn.region.f2, start}, Ink::grey);
  if (last > 0) {
    forbid(drawn.problem.residual ? "too strong: rests too far off" : "too strong: does not return",
           {last, 0}, {std::min(f4, f_max), start}, Ink::grey);
  }
  forbid("too strong: acceleration", {f4, 0}, {f_max, start}, Ink::amber);
  forbid("above the largest f", {f_max, 0}, {far, start}, Ink::amber);
  if (drawn.limits.delta_max) {
    forbid("above the largest Δ", {0, *drawn.limits.delta_max * units.length}, {far, start},
           Ink::amber);
  }
}

}  // namespace stillpoint::report
