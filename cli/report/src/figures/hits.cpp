// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"
#include "sections.hpp"

#include <stillpoint/design/hits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

using design::HitEnd;
using figures::AreaLook;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

std::vector<FigurePoint> strip(double from, double to, double low, double high) {
  return {{from, low}, {to, low}, {to, high}, {from, high}};
}

struct Look {
  HitEnd end;
  const char* name;
  Ink ink;
  AreaLook look;
  const char* fate;  ///< of such hits; empty where a limit decides that the figure does not show
};

const Look& look_of(HitEnd end) {
  using enum HitEnd;
  static constexpr auto looks = std::to_array<Look>(
      {{held, "held", Ink::grey, AreaLook::hatched, "are held at the start"},
       {centred, "centred", Ink::sky, AreaLook::filled, ""},
       {off_centre, "off centre", Ink::amber, AreaLook::hatched, "rest off centre"},
       {alternating, "alternately centred and off centre", Ink::amber, AreaLook::filled,
        "may rest off centre"},
       {too_far, "too far", Ink::orange, AreaLook::hatched, "go too far"},
       {never_stops, "never stops", Ink::purple, AreaLook::hatched, "never stop"}});
  return *std::ranges::find(looks, end, &Look::end);
}

/// Neighbours of different returns differ.
Ink ink_of(const design::Hits& now) {
  constexpr std::array centred{Ink::sky, Ink::green, Ink::purple};
  return now.end == HitEnd::centred ? centred.at(static_cast<std::size_t>(
                                          std::fmod(now.arrivals.value_or(1) - 1, centred.size())))
                                    : look_of(now.end).ink;
}

/// "off centre with some spring", "centred on return 2"
std::string named(const design::Hits& now) {
  const bool later = now.end == HitEnd::centred && now.arrivals.value_or(1) > 1;
  return fmt::format("{}{}{}", look_of(now.end).name,
                     later ? fmt::format(" on return {}", *now.arrivals) : "",
                     now.every_spring ? "" : " with some spring");
}

/// Whether hits above those that the damper works for stop by the exact criterion.
bool exact_works_above(design::Problem problem, const design::Limits& limits, double f,
                       double delta, double highest) {
  if (problem.criterion == design::Criterion::exact) {
    return false;
  }
  constexpr double above = 1 + 1e-6;
  problem.criterion = design::Criterion::exact;
  const auto exact = design::works_for(problem, limits, f, delta);
  return exact && exact->v0.high > above * highest;
}

/// The hits whose peak is within beta, but whose acceleration outside the notch is not within its
/// limit: sqrt(f^2 + (v0 p)^2) is above it, with the stiffest spring.
std::optional<Interval> above_limit(const design::Problem& problem, const design::Limits& limits,
                                    double f, const std::vector<design::Hits>& hits) {
  if (!limits.acceleration_max) {
    return std::nullopt;
  }
  const double limit = *limits.acceleration_max;
  const double from =
      limit > f ? std::sqrt((limit - f) * (limit + f)) / problem.p_high.value_or(problem.p) : 0;
  const auto far = std::ranges::find(hits, HitEnd::too_far, &design::Hits::end);
  const double to = far == hits.end() ? hits.back().to : far->from;
  return from < to ? std::optional(Interval{from, to}) : std::nullopt;
}

/// "; weaker ones are held at the start and stronger ones go too far"
std::string other_hits(const design::ServedInterval& works, const std::vector<design::Hits>& hits,
                       const std::optional<double>& acceleration_max, bool by_criterion) {
  constexpr double beside = 1e-6;  // an edge of both may differ by rounding
  const double weaker = works.low * (1 - beside);
  const double stronger = works.high.value_or(HUGE_VAL) * (1 + beside);
  std::vector<std::string> fates;
  const auto add = [&fates](std::string fate) { fates.push_back(std::move(fate)); };
  bool says_above = false;
  for (const design::Hits& now : hits) {
    const bool below = now.from < weaker && weaker <= now.to;
    const bool above = now.from <= stronger && stronger < now.to;
    const std::string_view fate = look_of(now.end).fate;
    if ((below || above) && !fate.empty()) {
      const bool last = below ? now.from == 0 : now.to == hits.back().to;
      add(fmt::format("{}{} ones {}{}", last ? "" : "slightly ", below ? "weaker" : "stronger",
                      fate, now.every_spring ? "" : " with some spring"));
      says_above = says_above || above;
    }
  }
  if (by_criterion) {
    add("slightly stronger ones stop too, but not by the published criterion");
    says_above = true;
  }
  if (acceleration_max && !says_above) {
    add(fmt::format("stronger ones feel more than {:.4g} g", *acceleration_max));
  }
  std::string text;
  for (const std::string& fate : fates) {
    text += (&fate == &fates.front() ? "; " : &fate == &fates.back() ? " and " : ", ") + fate;
  }
  return text;
}

std::string where_it_fails(const design::Problem& problem, const std::vector<design::Hits>& hits) {
  if (problem.v0_low) {
    return "The damper does not work for every hit of the range.";
  }
  const auto now = std::ranges::find_if(hits, [&](const design::Hits& each) {
    return each.from < problem.v0 && problem.v0 < each.to;
  });
  const std::string_view fate = now == hits.end() ? "" : look_of(now->end).fate;
  return fmt::format("The damper does not work for the hit that was asked for{}{}.",
                     fate.empty() ? "" : ": such hits ", fate);
}

/// The hits of the task as lines.
figures::FigureCurve asked(const design::Problem& problem, const FigureUnits& units) {
  figures::FigureCurve curve;
  curve.name = problem.v0_low == 0.0 ? "V₀ up to " : "V₀ = ";
  curve.ink = Ink::blue;
  curve.dash = figures::Dash::dashed;
  curve.hover = false;
  const auto add = [&](double v0) {
    curve.name += units.velocity_words(v0);
    curve.strokes.push_back({{v0 * units.velocity, 0}, {v0 * units.velocity, 1}});
  };
  if (const double low = problem.v0_low.value_or(0); low > 0) {
    add(low);
    curve.name += " to ";
  }
  add(problem.v0);
  return curve;
}

}  // namespace

Figure hits_figure(const design::Problem& problem, const design::Limits& limits, double f,
                   double delta, const std::optional<design::WorksFor>& works_for,
                   const FigureUnits& units) {
  constexpr double narrowest = 0.005;  // of the figure, to be seen
  const double unit = units.velocity;
  const auto hits = design::shown_hits_of_springs(problem, f, delta);
  const auto felt = above_limit(problem, limits, f, hits);
  Figure figure;
  figure.id = "hits";
  figure.title = problem.p_high ? "Where the mass stops with the worst spring"
                                : "Where the mass stops after a hit";
  figure.height = 150;
  const double known = hits.back().to * unit;
  figure.x = {units.velocity_unit.empty() ? "velocity of the hit, V₀"
                                          : "velocity of the hit V₀, " + units.velocity_unit,
              0, 2 * problem.v0 * unit};
  if (works_for) {  // the first to be named
    const auto& [low, high] = works_for->v0;
    const std::string range =
        interval_text({low * unit, *high * unit}) + with_blank(units.velocity_unit);
    auto box = strip(low * unit, *high * unit, 0.05, 0.3);
    add_box_inset(figure, box);
    figure.areas.push_back({"works for " + range, std::move(box), Ink::blue, AreaLook::box});
    figure.caption =
        fmt::format("The damper works for hits of {}{}.", range,
                    other_hits(works_for->v0, hits, felt ? limits.acceleration_max : std::nullopt,
                               exact_works_above(problem, limits, f, delta, *high)));
  } else {
    figure.caption = where_it_fails(problem, hits);
  }
  figure.description = "Ends of the motion by the velocity of the hit:";
  for (const design::Hits& now : hits) {
    const bool seen = now.to - now.from >= narrowest * hits.back().to;
    figure.areas.push_back({.name = seen ? named(now) : "",
                            .outline = strip(now.from * unit, now.to * unit, 0, 1),
                            .ink = ink_of(now),
                            .look = look_of(now.end).look,
                            .again = true});
    figure.description +=
        fmt::format("{} {} from {} to {}", &now == hits.data() ? "" : ",", named(now),
                    units.velocity_words(now.from), units.velocity_words(now.to));
  }
  if (known < figure.x.most) {  // beyond what the program takes
    figure.areas.push_back(
        {"not computed", strip(known, figure.x.most, 0, 1), Ink::purple, AreaLook::hatched});
  }
  if (felt) {
    figure.areas.push_back({fmt::format("above {:.4g} g", *limits.acceleration_max),
                            strip(felt->low * unit, felt->high * unit, 0, 1), Ink::purple,
                            AreaLook::hatched});
  }
  figure.description += ". " + figure.caption;
  figure.curves.push_back(asked(problem, units));
  return figure;
}

}  // namespace stillpoint::report
