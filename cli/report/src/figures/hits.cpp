// SPDX-License-Identifier: MIT
#include "figures/region_figures.hpp"

#include <stillpoint/design/hits.hpp>

#include <array>

namespace stillpoint::report {

using design::HitEnd;
using design::Hits;

namespace {

/// How the motion ends over the strength of what sets it off, a hit or a pulse.
struct DrawnEnds {
  std::string_view noun;      ///< "hit"
  std::string_view measured;  ///< "hits"
  std::string_view symbol;    ///< of the strength
  std::string title;
  std::string label;  ///< of the axis
  Unit unit;          ///< there
  std::vector<Hits> list;
  Interval asked;  ///< the strengths of the task
  bool has_range;
  double arrivals{1};  ///< at which it may rest
};

DrawnEnds after_hits(const ShownTask& task, double f, double delta) {
  const design::Problem& problem = task.problem;
  const Unit unit = units_of(task.physical).velocity;
  return {"hit",
          "hits",
          "V₀",
          problem.p_high ? "Where the mass stops with the worst spring"
                         : "Where the mass stops after a hit",
          "velocity of the hit" + (unit.name.empty() ? ", V₀" : " V₀, " + unit.name),
          unit,
          design::shown_hits(problem, f, delta),
          {problem.v0_low.value_or(problem.v0), problem.v0},
          problem.v0_low.has_value(),
          static_cast<double>(problem.arrivals)};
}

/// At the first return, and somewhat beyond those that it works for.
DrawnEnds under_pulses(const ShownTask& task, double f, double delta,
                       const std::optional<design::WorksFor>& works_for) {
  constexpr double room = 1.25;
  const auto problem = design::pulse_problem(task.problem, *task.pulse, task.ranges);
  const double k = design::peak_load(problem.pulse);
  const double works = works_for ? works_for->hit.high.value_or(0) : 0;
  return {"pulse",
          "pulses with k",
          "k",
          problem.p_high || problem.ranges.lambda_high
              ? "Where the mass stops under the worst of the pulses"
              : "Where the mass stops under the pulse",
          "largest acceleration of the pulse k, g",
          {1, "g"},
          design::shown_strengths(problem, f, delta, room * works),
          {problem.ranges.k_low.value_or(k), k},
          problem.has_ranges()};
}

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

Ink ink_of(const Hits& now) {
  return now.end == HitEnd::centred ? arrival_ink(now.arrivals.value_or(1)) : look_of(now.end).ink;
}

std::string some_spring(const Hits& now) {
  return now.every_spring ? "" : " with some spring";
}

bool is_later(const Hits& now) {
  return now.end == HitEnd::centred && now.arrivals.value_or(0) > 1;
}

/// "off centre with some spring", "centred at arrival 2", "within the residual after 1 passage"
std::string named(const Hits& now) {
  const double arrivals = now.arrivals.value_or(0);
  const std::string later = is_later(now) ? format(" at arrival {}", arrivals)
                            : now.end == HitEnd::within_residual && arrivals > 0
                                ? " after " + plural(arrivals, "passage")
                                : "";
  return look_of(now.end).name + later + some_spring(now);
}

/// "centred at arrivals 2, 5", which have one ink; empty if no other has it.
std::string key_of_later(const DrawnEnds& drawn, const Hits& one) {
  std::set<double> arrivals;
  for (const Hits& now : drawn.list) {
    if (is_later(now) && now.every_spring == one.every_spring) {
      arrivals.insert(*now.arrivals);
    }
  }
  const std::string key = is_later(one) ? key_of_arrivals(arrivals, *one.arrivals) : "";
  return key.empty() ? "" : "centred at " + key + some_spring(one);
}

/// "0.3 to 0.35 m/s", in as many digits as tell them apart.
std::string words(const DrawnEnds& drawn, double from, double to) {
  constexpr int fewest = 4;
  const auto ends = figures::tick_labels({from * drawn.unit, to * drawn.unit}, fewest);
  return format("{} to {}{}", ends[0], ends[1], with_blank(drawn.unit.name));
}

/// Those of the task as lines.
void add_asked(Figure& figure, const DrawnEnds& drawn) {
  const auto [low, high] = drawn.asked;
  const Points strongest = figure.upright(high * drawn.unit);
  if (drawn.has_range && low > 0) {
    figure.add_line(format("{} = {}", drawn.symbol, words(drawn, low, high)),
                    {figure.upright(low * drawn.unit), strongest}, Ink::blue, Dash::dashed);
  } else {
    figure.add_line(format("{} {}{:.4g}{}", drawn.symbol, low == 0 ? "up to " : "= ",
                           high * drawn.unit, with_blank(drawn.unit.name)),
                    {strongest}, Ink::blue, Dash::dashed);
  }
}

/// The box around those that the damper works for.
void add_works(Figure& figure, const DrawnEnds& drawn, const design::ServedInterval& works) {
  const Unit& unit = drawn.unit;
  const Interval shown{works.low * unit, *works.high * unit};
  const std::string range = interval_text({shown.low, shown.high}) + with_blank(drawn.unit.name);
  auto box = rectangle(shown.low, shown.high, 0.05, 0.3);
  add_box_inset(figure, box);
  figure.areas.push_back({"works for " + range, std::move(box), Ink::blue, AreaLook::box});
  figure.clauses = {
      format("The damper works for {} of {}", drawn.measured, range),
      format("{}s beside them violate a requirement, even where the mass stops", drawn.noun)};
  if (figure.inset) {
    const FigureAxis& x = figure.inset->x;
    figure.clauses.push_back(format("the corner enlarges {}{}", interval_digits(x.least, x.most),
                                    with_blank(drawn.unit.name)));
  }
}

void add_end(Figure& figure, const DrawnEnds& drawn, const Hits& now) {
  const std::string name = named(now);
  const std::string range = words(drawn, now.from, now.to);
  const bool off = now.end == HitEnd::within_residual;
  const bool too_late = off && now.arrivals.value_or(0) >= drawn.arrivals;
  const std::string allowed =
      too_late ? "within the residual, but too late" : "within the residual";
  figure.areas.push_back({.name = name,
                          .outline = rectangle(now.from * drawn.unit, now.to * drawn.unit, 0, 1),
                          .ink = ink_of(now),
                          .look = too_late ? AreaLook::hatched : look_of(now.end).look,
                          .again = true,
                          .told = format("{}, {}", name, range),
                          .key = off ? allowed + some_spring(now) : key_of_later(drawn, now)});
  figure.description += format("{} {} from {}", &now == drawn.list.data() ? "" : ",", name, range);
}

}  // namespace

Figure ends_figure(const ShownTask& task, double f, double delta,
                   const std::optional<design::WorksFor>& works_for) {
  const DrawnEnds drawn =
      task.pulse ? under_pulses(task, f, delta, works_for) : after_hits(task, f, delta);
  const Unit& unit = drawn.unit;
  const double known = drawn.list.back().to * unit;
  const double asked_for = 2 * drawn.asked.high * unit;
  Figure figure{format("{}s", drawn.noun), drawn.title};
  figure.height = 150;
  figure.x = {drawn.label, 0, std::max(known, asked_for)};
  if (works_for) {  // the first to be named
    add_works(figure, drawn, works_for->hit);
  } else {
    figure.clauses = {
        drawn.has_range
            ? format("The damper does not work for every {} of the range", drawn.noun)
            : format("The damper does not work for the {} that was asked for", drawn.noun)};
  }
  figure.description = format("Ends of the motion by the strength of the {}:", drawn.noun);
  for (const Hits& now : drawn.list) {
    add_end(figure, drawn, now);
  }
  if (known < asked_for) {  // beyond what the program takes
    figure.add_band("not computed", known, figure.x.most, Ink::purple, AreaLook::hatched);
  }
  figure.description += ". " + figure.caption();
  add_asked(figure, drawn);
  if (const auto felt = task.pulse
                            ? std::nullopt
                            : design::hits_above_limit(task.problem, task.limits, f, drawn.list)) {
    figure.add_band(format("above {:.4g} g", *task.limits.acceleration_max), felt->low * unit,
                    felt->high * unit, Ink::purple, AreaLook::hatched);
  }
  return figure;
}

}  // namespace stillpoint::report
