// SPDX-License-Identifier: MIT
#include "figures/region_column.hpp"
#include "figures/report_figures.hpp"
#include "format.hpp"

#include <stillpoint/design/strips.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::FigureArea;
using figures::FigurePoint;
using figures::Ink;

namespace {

constexpr int strip_steps = 200;  // of an edge over f

/// One arrival, or those from `first` to the last one allowed; 0: any rest within the residual.
struct DrawnStrip {
  std::int64_t first{0};
  bool with_later{false};
};

/// The strips of a region within its limits, regardless of the tolerance.
class Strips {
 public:
  Strips(const DrawnRegion& drawn, double unit)
      : drawn_(drawn), unit_(unit), plain_(is_plain(drawn.problem, {})) {
    if (!plain_) {
      design::Limits no_box = drawn.limits;
      no_box.tolerance = 0;
      found_ = design::strips(drawn.problem, no_box);
    }
    const auto rest = drawn.problem.residual ? extent(0) : std::nullopt;
    rest_end_ = rest ? rest->high : 0;
  }

  [[nodiscard]] std::vector<FigurePoint> outline(const DrawnStrip& strip) const {
    const auto f = extent(strip.first);
    if (!f) {
      return {};
    }
    const double from = strip.first > 0 ? std::max(f->low, rest_end_) : f->low;
    const double most = design::largest_delta_allowed(drawn_.limits);
    std::vector<FigurePoint> lower;
    std::vector<FigurePoint> upper;
    const auto has = [&](double at) {
      const auto range = range_at(strip, at);
      return range && range->low <= most;
    };
    const auto add = [&](double at) {
      const auto range = range_at(strip, at);
      lower.push_back({at, range->low * unit_});
      upper.push_back({at, std::min(range->high, most) * unit_});
    };
    double last = from;
    bool had = false;
    for (int i = 0; from <= f->high && i <= strip_steps; ++i) {
      const double at = from + (f->high - from) * i / strip_steps;
      const bool now = has(at);
      if (i > 0 && had != now) {  // it begins or ends between them
        add(had ? last_inside(last, at, has) : last_inside(at, last, has));
      }
      if (now) {
        add(at);
      }
      had = now;
      last = at;
    }
    if (lower.size() < 2) {
      return {};
    }
    lower.insert(lower.end(), upper.rbegin(), upper.rend());
    return lower;
  }

  /// That of the damper: 0 for any rest within the residual, -1 for none.
  [[nodiscard]] std::int64_t own() const {
    if (is_one_strip(drawn_.problem)) {
      return 1;
    }
    if (!drawn_.damper) {
      return -1;
    }
    const DrawnDamper& damper = *drawn_.damper;
    const std::int64_t arrival =
        design::arrival_of(drawn_.problem, damper.f, damper.delta).value_or(0);
    return damper.f <= rest_end_ || !extent(arrival) ? 0 : arrival;
  }

 private:
  [[nodiscard]] std::optional<Interval> range_at(const DrawnStrip& strip, double f) const {
    auto range = design::delta_range(drawn_.problem, strip.first, f);
    if (range && strip.with_later) {
      range->low = design::least_stopping_delta(drawn_.problem, f);
    }
    return range;
  }

  /// Of f.
  [[nodiscard]] std::optional<Interval> extent(std::int64_t arrival) const {
    if (plain_ && arrival > 0) {
      const auto n = static_cast<double>(arrival);
      const double tip = drawn_.problem.v0 * drawn_.problem.p / (2 * std::sqrt(n * (n + 1)));
      return Interval{std::max(drawn_.region.f2, 0.0),
                      std::min(arrival == 1 ? drawn_.region.f3 : tip,
                               design::largest_f_allowed(drawn_.problem, drawn_.limits))};
    }
    const auto found = std::ranges::find(found_, arrival, &design::Strip::arrival);
    return found != found_.end() && found->f_lower
               ? std::optional(Interval{*found->f_lower, *found->f_upper})
               : std::nullopt;
  }

  const DrawnRegion& drawn_;
  double unit_;
  bool plain_;
  std::vector<design::Strip> found_;
  double rest_end_{0};  ///< up to this f any rest is within the residual, whatever the arrival
};

/// Neighbours may touch, so they differ; the damper's own is like any admissible area.
constexpr std::array inks{Ink::orange, Ink::green, Ink::purple};
Ink strip_ink(const DrawnStrip& strip, std::int64_t own) {
  return strip.first == own ? Ink::sky
         : strip.first == 0 ? Ink::amber
         : strip.with_later ? Ink::grey
                            : inks.at(static_cast<std::size_t>(strip.first) % inks.size());
}

/// The first of each ink.
bool may_be_in_legend(const DrawnStrip& strip, std::int64_t own) {
  return strip.first == own || strip.with_later ||
         strip.first <= static_cast<std::int64_t>(inks.size());
}

std::string strip_name(const DrawnRegion& drawn, const DrawnStrip& strip) {
  if (is_one_strip(drawn.problem)) {
    return drawn.region.feasible && drawn.limits.tolerance == 0 ? "admissible"
                                                                : "admissible without a tolerance";
  }
  return strip.first == 0   ? "any rest within the residual"
         : strip.with_later ? format("arrivals {} to {}, thin strips with gaps", strip.first,
                                     drawn.problem.arrivals)
                            : format("arrival {}", strip.first);
}

}  // namespace

bool is_one_strip(const design::Problem& problem) {
  return problem.arrivals == 1 && !problem.residual;
}

std::vector<FigureArea> admissible_areas(const DrawnRegion& drawn, const FigureUnits& units) {
  const Strips strips(drawn, units.length);
  const std::int64_t own = strips.own();
  std::vector<FigureArea> areas;
  const auto add = [&](const DrawnStrip& strip) {
    if (auto outline = strips.outline(strip); !outline.empty()) {
      areas.push_back({strip_name(drawn, strip), std::move(outline), strip_ink(strip, own),
                       figures::AreaLook::filled, may_be_in_legend(strip, own)});
    }
  };
  if (drawn.problem.residual) {
    add({0});
  }
  const std::int64_t arrivals = drawn.problem.arrivals;
  for (std::int64_t n = 1; n <= std::min(arrivals, most_drawn_strips); ++n) {
    if (n != own) {
      add({n});
    }
  }
  if (arrivals > most_drawn_strips) {
    add({most_drawn_strips + 1, arrivals > most_drawn_strips + 1});
  }
  if (own > 0) {
    add({own});
  }
  return areas;
}

}  // namespace stillpoint::report
