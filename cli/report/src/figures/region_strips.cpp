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
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::FigureArea;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// One arrival, or those from `first` to the last one allowed; 0: any rest within the residual.
struct DrawnStrip {
  std::int64_t first{0};
  bool with_later{false};
  bool at_peak{false};  ///< as in Strip
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
    const auto f = extent(strip.first, strip.at_peak);
    if (!f) {
      return {};
    }
    const double from = strip.first > 0 ? std::max(f->low, rest_end_) : f->low;
    return outline_over({from, f->high}, unit_, [&](double at) { return range_at(strip, at); });
  }

  /// The arrival at which the damper stops the mass; 0 for none.
  [[nodiscard]] std::int64_t own() const {
    const auto& damper = drawn_.damper;
    const auto arrival = damper && is_within(*damper) && damper->f > rest_end_
                             ? design::arrival_of(drawn_.problem, damper->f, damper->delta)
                             : std::nullopt;
    return arrival && extent(*arrival) ? *arrival : 0;
  }

 private:
  [[nodiscard]] std::optional<Interval> range_at(const DrawnStrip& strip, double f) const {
    auto range = design::delta_range(drawn_.problem, strip.first, f);
    if (range && strip.with_later) {
      range->low = design::least_stopping_delta(drawn_.problem, f);
    }
    if (range) {
      range->high = std::min(range->high, design::largest_delta_allowed(drawn_.limits));
    }
    return range && range->low <= range->high ? range : std::nullopt;
  }

  /// Of f.
  [[nodiscard]] std::optional<Interval> extent(std::int64_t arrival, bool at_peak = false) const {
    if (plain_ && arrival > 0) {
      const auto n = static_cast<double>(arrival);
      const double tip = drawn_.problem.v0 * drawn_.problem.p / (2 * std::sqrt(n * (n + 1)));
      return Interval{std::max(drawn_.region.f2, 0.0),
                      std::min(arrival == 1 ? drawn_.region.f3 : tip,
                               design::largest_f_allowed(drawn_.problem, drawn_.limits))};
    }
    const auto found = std::ranges::find_if(found_, [&](const design::Strip& strip) {
      return strip.arrival == arrival && strip.at_peak == at_peak;
    });
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

Ink strip_ink(const DrawnStrip& strip) {
  return strip.first == 0   ? Ink::amber
         : strip.with_later ? Ink::grey
                            : arrival_ink(static_cast<double>(strip.first));
}

constexpr std::string_view with_gaps = ", thin strips with gaps";

std::string strip_name(const DrawnRegion& drawn, const DrawnStrip& strip) {
  return strip.first == 0 ? "any rest within the residual"
         : strip.with_later
             ? format("arrivals {} to {}{}", strip.first, drawn.problem.arrivals, with_gaps)
             : format("arrival {}", strip.first);
}

}  // namespace

bool has_gaps(const FigureArea& strip) {
  return strip.name.ends_with(with_gaps);
}

Ink arrival_ink(double arrival) {
  constexpr std::array inks{Ink::sky, Ink::green, Ink::purple};
  return inks.at(static_cast<std::size_t>(std::fmod(arrival - 1, inks.size())));
}

std::string key_of_arrivals(const std::set<double>& arrivals, double one) {
  constexpr std::size_t most = 6;
  std::vector<double> alike;
  std::ranges::copy_if(arrivals, std::back_inserter(alike),
                       [one](double arrival) { return arrival_ink(arrival) == arrival_ink(one); });
  if (alike.size() < 2) {
    return "";
  }
  std::string text = "arrivals";
  for (std::size_t i = 0; i < alike.size(); ++i) {
    if (i < most || i + 1 == alike.size()) {
      text += format("{} {}", i == 0 ? "" : i > most ? ", …," : ",", alike[i]);
    }
  }
  return text;
}

bool is_one_area(const design::Problem& problem, std::size_t areas) {
  return problem.arrivals == 1 && areas == 1;
}

std::vector<FigureArea> admissible_areas(const DrawnRegion& drawn, const FigureUnits& units) {
  const Strips strips(drawn, units.length);
  const std::int64_t own = strips.own();
  std::vector<FigureArea> areas;
  std::vector<double> arrival_of;  // each area; 0 where it is not that of one arrival
  const auto add = [&](const DrawnStrip& strip) {
    if (auto outline = strips.outline(strip); !outline.empty()) {
      areas.push_back({strip_name(drawn, strip), std::move(outline), strip_ink(strip)});
      arrival_of.push_back(strip.with_later ? 0 : static_cast<double>(strip.first));
    }
  };
  if (drawn.problem.residual) {
    add({0});
    add({.first = 0, .at_peak = true});
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
  std::set<double> listed(arrival_of.begin(), arrival_of.end());
  listed.erase(0);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    areas[i].key = arrival_of[i] > 0 ? key_of_arrivals(listed, arrival_of[i]) : "";
  }
  if (is_one_area(drawn.problem, areas.size())) {
    areas.front().name = drawn.region.feasible && drawn.limits.tolerance == 0
                             ? "admissible"
                             : "admissible without a tolerance";
    areas.front().ink = Ink::sky;
  }
  return areas;
}

std::vector<std::vector<FigurePoint>> tolerant_areas(const DrawnRegion& drawn, double unit) {
  std::vector<std::vector<FigurePoint>> areas;
  if (drawn.limits.tolerance == 0) {
    return areas;
  }
  const auto strips = design::strips(drawn.problem, drawn.limits);
  // Up to this f any rest is within the residual, whatever the arrival.
  const auto rest = std::ranges::find_if(
      strips, [](const design::Strip& strip) { return strip.arrival == 0 && !strip.at_peak; });
  const double rest_end = rest == strips.end() ? 0 : rest->f_upper.value_or(0);
  for (const design::Strip& strip : strips) {
    if (strip.f_lower && strip.arrival <= most_drawn_strips) {
      const double from = strip.arrival > 0 ? std::max(*strip.f_lower, rest_end) : *strip.f_lower;
      areas.push_back(outline_over({from, *strip.f_upper}, unit, [&](double f) {
        return design::feasible_delta(drawn.problem, drawn.limits, strip.arrival, f);
      }));
    }
  }
  return areas;
}

}  // namespace stillpoint::report
