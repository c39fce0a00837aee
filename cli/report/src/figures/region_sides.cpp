// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::AreaLook;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

constexpr int edge_steps = 100;
using Level = std::function<double(double)>;

/// Between two levels of Delta over f; empty where the upper is never above the lower.
std::vector<FigurePoint> between(double from, double to, const Level& lower, const Level& upper) {
  std::vector<FigurePoint> below;
  std::vector<FigurePoint> above;
  bool something = false;
  for (int i = 0; i <= edge_steps; ++i) {
    const double f = from + (to - from) * i / edge_steps;
    const double low = lower(f);
    const double high = std::max(low, upper(f));
    something = something || high > low;
    below.push_back({f, low});
    above.push_back({f, high});
  }
  below.insert(below.end(), above.rbegin(), above.rend());
  return something ? below : std::vector<FigurePoint>{};
}

/// If it is not empty.
void add(Figure& figure, std::string name, std::vector<FigurePoint> outline, Ink ink = Ink::grey,
         AreaLook look = AreaLook::hatched) {
  if (!outline.empty()) {
    figure.areas.push_back({std::move(name), std::move(outline), ink, look});
  }
}

}  // namespace

void add_sides(Figure& figure, const DrawnRegion& drawn, const RegionSpan& span,
               const FigureUnits& units) {
  const double unit = units.length;
  const double x_least = figure.x.least;
  const double x_most = figure.x.most;
  const double y_least = figure.y.least;
  const double y_most = figure.y.most;
  const Level least = [&](double /*f*/) { return y_least; };
  const Level most = [&](double /*f*/) { return y_most; };
  const Level stop = [&](double f) {
    return std::clamp(design::delta1(span.at(f), f).value_or(0) * unit, y_least, y_most);
  };
  const Level start = [&](double f) {
    const double v0 = span.at(std::min(f, span.last)).v0;
    return std::clamp(v0 * v0 / 2 * unit, y_least, y_most);
  };
  const Level top = [&](double f) {
    return std::clamp(drawn.limits.delta_max.value_or(HUGE_VAL) * unit, y_least, start(f));
  };
  const auto upright = [&](const std::string& name, double from, double to, Ink ink = Ink::grey,
                           AreaLook look = AreaLook::hatched) {
    from = std::max(from, x_least);
    to = std::min(to, x_most);
    if (from < to) {
      add(figure, name, between(from, to, least, start), ink, look);
    }
  };
  const std::string limit = units.length_words(drawn.problem.beta);
  const bool returns = span.last <= drawn.region.f1;
  const double strong = returns ? span.last : drawn.region.f1;
  // Where both sides forbid the same f, that is the gap.
  upright("too weak: exceeds " + limit, 0, std::min(span.first, strong));
  upright(returns ? "too strong: does not return" : "too strong: rests too far off",
          std::max(span.first, strong), x_most);
  upright("gap: no f returns within " + limit, strong, span.first, Ink::orange, AreaLook::filled);
  add(figure, "notch holds at the start", between(x_least, x_most, start, most));
  const double from = std::max(span.first, x_least);
  double to = std::min(strong, x_most);
  if (const double last = span.last_within_limits(drawn); last < to) {
    upright(last == drawn.region.f4 ? "too strong: acceleration" : "above the largest f",
            std::max(last, from), to, Ink::amber);
    to = last;
  }
  if (from < to) {
    add(figure, "notch too weak",
        between(from, to, least, [&](double f) { return std::min(stop(f), top(f)); }));
    add(figure, "above the largest Δ",
        between(
            from, to, [&](double f) { return std::max(stop(f), top(f)); }, start),
        Ink::amber);
    add(figure, "gap: no notch is strong enough", between(from, to, top, stop), Ink::orange,
        AreaLook::filled);
  }
}

}  // namespace stillpoint::report
