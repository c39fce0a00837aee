// SPDX-License-Identifier: MIT
#include "figures/region_figures.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/design/hits.hpp>
#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>

namespace stillpoint::report {

using design::HitEnd;
using figures::AreaLook;
using figures::Figure;
using figures::Ink;
using figures::rectangle;

namespace {

/// How the motion ends over the strength of what sets it off, a hit or a pulse.
struct DrawnEnds {
  std::string_view noun;      ///< "hit"
  std::string_view measured;  ///< "hits"
  std::string symbol;         ///< of the strength
  double scale{1};            ///< from a strength to its place on the axis
  std::string unit;           ///< there, may be empty
  std::vector<design::Hits> list;
  Interval asked;      ///< the strengths of the task
  double arrivals{1};  ///< at which it may rest
  bool has_range{false};
  std::optional<design::ServedInterval> works;
};

struct Look {
  HitEnd end;
  const char* name;
  Ink ink;
  AreaLook look;
};

const Look& look_of(HitEnd end) {
  using enum HitEnd;
  static constexpr auto looks = std::to_array<Look>(
      {{held, "held", Ink::grey, AreaLook::hatched},
       {centred, "centred", Ink::sky, AreaLook::filled},
       {within_residual, "within the residual", Ink::amber, AreaLook::filled},
       {off_centre, "off centre", Ink::amber, AreaLook::hatched},
       {alternating, "alternately centred and off centre", Ink::amber, AreaLook::filled},
       {passes, "passes x = 0", Ink::amber, AreaLook::filled},
       {too_far, "too far", Ink::orange, AreaLook::hatched},
       {never_stops, "never stops", Ink::purple, AreaLook::hatched}});
  return *std::ranges::find(looks, end, &Look::end);
}

Ink ink_of(const design::Hits& now) {
  return now.end == HitEnd::centred ? arrival_ink(now.arrivals.value_or(1)) : look_of(now.end).ink;
}

std::string some_spring(const design::Hits& now) {
  return now.every_spring ? "" : " with some spring";
}

bool is_later(const design::Hits& now) {
  return now.end == HitEnd::centred && now.arrivals.value_or(0) > 1;
}

/// "off centre with some spring", "centred at arrival 2", "within the residual after 1 passage"
std::string named(const design::Hits& now) {
  const double arrivals = now.arrivals.value_or(0);
  const std::string later = is_later(now) ? format(" at arrival {}", arrivals)
                            : now.end == HitEnd::within_residual && arrivals > 0
                                ? " after " + plural(arrivals, "passage")
                                : "";
  return look_of(now.end).name + later + some_spring(now);
}

/// "centred at arrivals 2, 5", which have one ink; empty if no other has it.
std::string key_of_later(const DrawnEnds& drawn, const design::Hits& one) {
  std::set<double> arrivals;
  for (const design::Hits& now : drawn.list) {
    if (is_later(now) && now.every_spring == one.every_spring) {
      arrivals.insert(*now.arrivals);
    }
  }
  const std::string key = is_later(one) ? key_of_arrivals(arrivals, *one.arrivals) : "";
  return key.empty() ? "" : "centred at " + key + some_spring(one);
}

std::string words(const DrawnEnds& drawn, double strength) {
  return format("{:.4g}{}", strength * drawn.scale, with_blank(drawn.unit));
}

/// "0.3 to 0.35 m/s", in as many digits as tell them apart.
std::string words(const DrawnEnds& drawn, double from, double to) {
  constexpr int fewest = 4;
  const auto ends = figures::tick_labels({from * drawn.scale, to * drawn.scale}, fewest);
  return format("{} to {}{}", ends[0], ends[1], with_blank(drawn.unit));
}

/// Those of the task as lines.
figures::FigureCurve asked(const DrawnEnds& drawn) {
  const auto& [low, high] = drawn.asked;
  const bool from_low = 0 < low && drawn.has_range;
  std::vector<std::vector<figures::FigurePoint>> strokes;
  for (const double strength : from_low ? std::vector{low, high} : std::vector{high}) {
    strokes.push_back({{strength * drawn.scale, 0}, {strength * drawn.scale, 1}});
  }
  return figures::line(format("{} {}{}", drawn.symbol, low == 0 ? "up to " : "= ",
                              from_low ? words(drawn, low, high) : words(drawn, high)),
                       std::move(strokes), Ink::blue, figures::Dash::dashed);
}

/// Without its title and the name of its axis.
Figure ends_figure(const DrawnEnds& drawn) {
  const double scale = drawn.scale;
  const double known = drawn.list.back().to * scale;
  const double asked_for = 2 * drawn.asked.high * scale;
  Figure figure;
  figure.id = format("{}s", drawn.noun);
  figure.height = 150;
  figure.x = {"", 0, std::max(known, asked_for)};
  if (drawn.works) {  // the first to be named
    const double low = drawn.works->low * scale;
    const double high = *drawn.works->high * scale;
    const std::string range =
        interval_text({low, high}, {drawn.asked.low * scale, drawn.asked.high * scale}) +
        with_blank(drawn.unit);
    auto box = rectangle(low, high, 0.05, 0.3);
    add_box_inset(figure, box);
    figure.areas.push_back({"works for " + range, std::move(box), Ink::blue, AreaLook::box});
    figure.clauses = {
        format("The damper works for {} of {}", drawn.measured, range),
        format("{}s beside them violate a requirement, even where the mass stops", drawn.noun)};
    if (figure.inset) {
      const figures::FigureAxis& x = figure.inset->x;
      figure.clauses.push_back(format("the corner enlarges {}{}", interval_digits(x.least, x.most),
                                      with_blank(drawn.unit)));
    }
  } else {
    figure.clauses = {format("The damper does not work for {} {}",
                             drawn.has_range ? "every" : "the", drawn.noun) +
                      (drawn.has_range ? " of the range" : " that was asked for")};
  }
  figure.description = format("Ends of the motion by the strength of the {}:", drawn.noun);
  for (const design::Hits& now : drawn.list) {
    const std::string name = named(now);
    const std::string range = words(drawn, now.from, now.to);
    const bool too_late =
        now.end == HitEnd::within_residual && now.arrivals.value_or(0) >= drawn.arrivals;
    figure.areas.push_back(
        {.name = name,
         .outline = rectangle(now.from * scale, now.to * scale, 0, 1),
         .ink = ink_of(now),
         .look = too_late ? AreaLook::hatched : look_of(now.end).look,
         .again = true,
         .told = format("{}, {}", name, range),
         .key = now.end != HitEnd::within_residual
                    ? key_of_later(drawn, now)
                    : (too_late ? "within the residual, but too late" : "within the residual") +
                          some_spring(now)});
    figure.description +=
        format("{} {} from {}", &now == drawn.list.data() ? "" : ",", name, range);
  }
  if (known < asked_for) {  // beyond what the program takes
    figure.areas.push_back(
        {"not computed", rectangle(known, figure.x.most, 0, 1), Ink::purple, AreaLook::hatched});
  }
  figure.description += ". " + figure.caption();
  figure.curves.push_back(asked(drawn));
  return figure;
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

std::optional<design::ServedInterval> hit_of(const std::optional<design::WorksFor>& works_for) {
  return works_for ? std::optional(works_for->hit) : std::nullopt;
}

}  // namespace

Figure hits_figure(const design::Problem& problem, const design::Limits& limits, double f,
                   double delta, const std::optional<design::WorksFor>& works_for,
                   const FigureUnits& units) {
  const double unit = units.velocity.factor;
  const auto hits = design::shown_hits(problem, f, delta);
  const auto felt = above_limit(problem, limits, f, hits);
  Figure figure = ends_figure({.noun = "hit",
                               .measured = "hits",
                               .symbol = "V₀",
                               .scale = unit,
                               .unit = units.velocity.name,
                               .list = hits,
                               .asked = {problem.v0_low.value_or(problem.v0), problem.v0},
                               .arrivals = static_cast<double>(problem.arrivals),
                               .has_range = problem.v0_low.has_value(),
                               .works = hit_of(works_for)});
  figure.title = problem.p_high ? "Where the mass stops with the worst spring"
                                : "Where the mass stops after a hit";
  figure.x.label = units.velocity.name.empty() ? "velocity of the hit, V₀"
                                               : "velocity of the hit V₀, " + units.velocity.name;
  if (felt) {
    figure.areas.push_back({format("above {:.4g} g", *limits.acceleration_max),
                            rectangle(felt->low * unit, felt->high * unit, 0, 1), Ink::purple,
                            AreaLook::hatched});
  }
  return figure;
}

Figure strengths_figure(const design::PulseProblem& problem, double f, double delta,
                        const std::optional<design::WorksFor>& works_for) {
  constexpr double room = 1.25;
  const double k = design::peak_load(problem.pulse);
  const auto works = hit_of(works_for);
  Figure figure = ends_figure({.noun = "pulse",
                               .measured = "pulses with k",
                               .symbol = "k",
                               .unit = "g",
                               .list = design::shown_strengths(
                                   problem, f, delta, works ? room * works->high.value_or(0) : 0),
                               .asked = {problem.ranges.k_low.value_or(k), k},
                               .has_range = problem.has_ranges(),
                               .works = works});
  figure.title = problem.p_high || problem.ranges.lambda_high
                     ? "Where the mass stops under the worst of the pulses"
                     : "Where the mass stops under the pulse";
  figure.x.label = "largest acceleration of the pulse k, g";
  return figure;
}

}  // namespace stillpoint::report
