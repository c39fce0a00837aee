// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::axis_around;
using figures::Dash;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// Where a motion is drawn.
using Place = std::function<FigurePoint(const State&)>;

/// The line through the crests on one side of a motion, whose turns are too many to be told apart:
/// the farthest in each column of time, without those between two that are farther.
std::vector<FigurePoint> crest_line(const std::vector<State>& states,
                                    const std::vector<State>& turns, double side, bool rests,
                                    const Place& place) {
  constexpr double columns = 180;
  const double column = states.back().tau / columns;
  const State& first = states.front();
  const State held = *std::prev(std::ranges::find_if(  // until it first moves
      states, [&](const State& state) { return state.x != first.x; }));
  std::vector<State> crests;
  for (const State& turn : turns) {
    if (!crests.empty() &&
        std::floor(turn.tau / column) == std::floor(crests.back().tau / column)) {
      crests.back() = side * turn.x > side * crests.back().x ? turn : crests.back();
    } else {
      crests.push_back(turn);
    }
  }
  std::vector<FigurePoint> line{place(first), place(held)};
  for (std::size_t i = 0; i < crests.size(); ++i) {
    const auto is_farther = [&](std::size_t other) {
      return other >= crests.size() || side * crests[other].x > side * crests[i].x;
    };
    if (!is_farther(i - 1) || !is_farther(i + 1)) {
      line.push_back(place(crests[i]));
    }
  }
  if (rests) {
    line.push_back(place(*std::next(states.rbegin())));
  }
  line.push_back({place(states.back()).x, rests ? place(states.back()).y : line.back().y});
  return line;
}

constexpr double rounding = 1 - 1e-12;

/// The first of the farthest: what rests there may be drawn a last digit farther out later on.
const State& farthest(const DrawnMotion& motion) {
  const auto distance = [](const State& state) { return std::abs(state.x); };
  const double most = distance(*std::ranges::max_element(motion.states, {}, distance));
  return *std::ranges::find_if(
      motion.states, [&](const State& state) { return distance(state) >= most * rounding; });
}

/// "starts at its peak of 0.5" or "reaches its peak of 137 mm after 0.585 s".
std::string reached(const State& peak, const FigureUnits& units) {
  const std::string length = units.length_words(peak.x);
  return peak.tau > 0
             ? format("reaches its peak of {} after {}", length, units.time_words(peak.tau))
             : format("starts at its peak of {}", length);
}

/// "at rest at x = 4.46 mm, inside the notch, after 1.53 s".
std::string words_of_rest(const DrawnMotion& motion, const FigureUnits& units) {
  if (!motion.rest) {
    return format("{} {}", motion.states.back().v == 0 ? "at rest" : "still moving",
                  motion.whole ? "at the end" : "where the figure ends");
  }
  const double x = motion.rest->x;
  const bool inside = x != 0 && 2 * std::abs(x) <= motion.surface.notch_width.value_or(0);
  return format("at rest at x = {}{} after {}", units.place_words(x),
                inside ? ", inside the notch," : "", units.time_words(motion.rest->tau));
}

bool is_long(const OtherMotion& other) {
  return other.turns.size() > most_single_half_cycles;
}

/// The largest |x|.
double reach(const std::vector<State>& states) {
  const auto [least, most] = extent(states, &State::x);
  return std::max(most, -least);
}

/// Another motion is cut off at so many times the peak or the limit.
constexpr double farthest_shown = 1.4;

/// Whether another motion is drawn; an envelope only if all of it is seen.
bool is_drawn(const DrawnMotion& motion, const OtherMotion& other) {
  constexpr double crossing = 3;  // times the peak: beyond that it would only cross the figure
  return !other.if_comparable ||
         reach(other.states) <=
             std::max((is_long(other) ? farthest_shown : crossing) * reach(motion.states),
                      farthest_shown * motion.beta.value_or(0));
}

/// Up to the motion and the limit, and to the motion without friction if that is not much larger.
figures::FigureAxis displacement_axis(const DrawnMotion& motion, const FigureUnits& units) {
  auto [least, most] = extent(motion.states, &State::x);
  if (least == most) {  // it never moves
    const double shown = motion.beta.value_or(motion.surface.notch_width.value_or(1));
    return axis_around(units.x_label, -shown * units.length, shown * units.length);
  }
  if (motion.beta) {
    least = least < 0 ? std::min(least, -*motion.beta) : 0;
    most = most > 0 ? std::max(most, *motion.beta) : 0;
  }
  constexpr double words = 0.08;  // room for the peak
  const double largest = std::max(most, -least);
  for (const OtherMotion& other : motion.others) {
    if (!is_drawn(motion, other)) {
      continue;
    }
    for (const State& state : other.states) {
      least = least < 0 ? std::min(least, std::max(state.x, -farthest_shown * largest)) : 0;
      most = most > 0 ? std::max(most, std::min(state.x, farthest_shown * largest)) : 0;
    }
  }
  const double room = words * (most - least);
  return axis_around(units.x_label, (least < 0 ? least - room : least) * units.length,
                     (most > 0 ? most + room : most) * units.length);
}

/// "without friction, beyond the frame to -158 mm", if the frame cuts it off.
std::string name_of(const OtherMotion& other, const figures::FigureAxis& axis,
                    const FigureUnits& units) {
  const std::string name = other.name + (is_long(other) ? " (envelope)" : "");
  const auto [least, most] = extent(other.states, &State::x);
  const bool below = least * units.length < axis.least;
  const bool above = most * units.length > axis.most;
  const auto [low, high] = other.reach;
  return below || above ? format("{}, beyond the frame to {}", name,
                                 units.place_words(above && (!below || high > -low) ? high : low))
                        : name;
}

/// Of one with too many half-cycles to be told apart the lines through its crests.
std::vector<std::vector<FigurePoint>> strokes_of(const OtherMotion& other, const Place& place) {
  if (!is_long(other)) {
    return {places(other.states, place)};
  }
  return {crest_line(other.states, other.turns, 1, false, place),
          crest_line(other.states, other.turns, -1, false, place)};
}

void add_limits(Figure& figure, const DrawnMotion& motion, const FigureUnits& units) {
  std::string name = format("limit {}", units.length_words(*motion.beta));
  for (const double limit : {*motion.beta, -*motion.beta}) {
    const double y = limit * units.length;
    if (figure.y.least < y && y < figure.y.most) {
      figure.curves.push_back(figures::line(std::exchange(name, ""),
                                            {{{figure.x.least, y}, {figure.x.most, y}}},
                                            Ink::orange, Dash::dashed, true));
    }
  }
}

}  // namespace

DrawnMotion::DrawnMotion(ShownMotion shown) : ShownMotion(std::move(shown)) {
  if (frictionless) {
    const bool slides = oscillator.f > 0 || !surface.zones.empty();
    others.push_back({.name = slides ? "without friction" : "without the notch",
                      .states = std::move(frictionless->states),
                      .reach = frictionless->reach,
                      .turns = std::move(frictionless->turns),
                      .if_comparable = true});
  }
}

void add_if_visible(DrawnMotion& motion, OtherMotion other) {
  double apart = 0;
  for (const State& state : motion.states) {
    apart = std::max(apart, std::abs(state.x - design::displacement(other.states, state.tau)));
  }
  constexpr double visible = 0.02;  // of the peak: a few pixels
  if (apart >= visible * reach(motion.states) && !is_long(motion)) {
    add(motion, std::move(other));
  }
}

void add(DrawnMotion& motion, OtherMotion other) {
  const double last = design::displacement(other.states, motion.shown_to);
  std::erase_if(other.states, [&](const State& state) { return state.tau > motion.shown_to; });
  other.states.push_back({motion.shown_to, last, 0});
  other.reach = extent(other.states, &State::x);
  motion.others.push_back(std::move(other));
}

bool is_moving(const DrawnMotion& motion) {
  return std::ranges::any_of(motion.states,
                             [](const State& state) { return state.tau > 0 && state.v != 0; });
}

std::string beginning(const DrawnMotion& motion) {
  return motion.whole ? "" : " (beginning)";
}

void add_zones(Figure& figure, const DrawnMotion& motion, double length, Along along) {
  const auto strip = [&](const std::string& name, Ink ink, double from, double to) {
    const figures::FigureAxis& long_way = along == Along::x ? figure.x : figure.y;
    const figures::FigureAxis& across = along == Along::x ? figure.y : figure.x;
    from = std::max(from * length, across.least);
    to = std::min(to * length, across.most);
    if (from < to && (from > across.least || to < across.most)) {  // else it is all
      auto outline = figures::rectangle(long_way.least, long_way.most, from, to);
      for (FigurePoint& at : outline) {
        at = along == Along::x ? at : FigurePoint{at.y, at.x};
      }
      figure.areas.push_back({name, std::move(outline), ink});
    }
  };
  double before = 0;
  for (const FrictionZone& zone : motion.surface.zones) {
    const std::string name = format("friction {:.4g}", zone.f);
    if (before == 0) {
      strip(name, Ink::sky, -zone.to, zone.to);
    } else {
      strip(name, Ink::sky, before, zone.to);
      strip(name, Ink::sky, -zone.to, -before);
    }
    before = zone.to;
  }
  if (const auto& width = motion.surface.notch_width) {
    strip("notch", Ink::green, -*width / 2, *width / 2);
  }
}

void add_lock(Figure& figure, const DrawnMotion& motion, const FigureUnits& units) {
  if (motion.locked) {
    const double from = *motion.locked;
    const std::string to =
        motion.locked_to ? " to " + units.time_words(*motion.locked_to) : std::string();
    figure.add_band(
        (from == 0 ? "locked throughout" : "locked from " + units.time_words(from)) + to,
        from * units.time, figure.x.most, Ink::amber);
  }
}

Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const Place place = [&](const State& state) {
    return FigurePoint{state.tau * units.time, state.x * units.length};
  };
  const bool long_one = is_long(motion);
  const State& peak = farthest(motion);
  const std::string peak_words = "peak " + units.length_words(peak.x);
  const std::string rest_words = words_of_rest(motion, units);
  Figure figure;
  figure.id = "motion";
  figure.title = "Motion" + beginning(motion);
  figure.x = {units.time_label, 0, motion.shown_to * units.time};
  figure.y = displacement_axis(motion, units);
  const bool moves = is_moving(motion);
  const bool stays = motion.rest && std::abs(motion.rest->x) >= std::abs(peak.x) * rounding;
  const std::string mass = motion.with.empty() ? "The mass" : motion.with + "the mass";
  figure.clauses = {(!moves  ? mass + " does not move"
                     : stays ? format("{} {} and stays there", mass, reached(peak, units))
                             : format("{} {} and is {}", mass, reached(peak, units), rest_words)) +
                    (long_one ? ", swinging within the shaded envelope" : "") +
                    (motion.locked_to ? format(", locked to {}, beyond this figure",
                                               units.time_words(*motion.locked_to))
                                      : "")};
  figure.description = "Displacement over time. " + figure.caption();
  add_zones(figure, motion, units.length, Along::x);
  add_lock(figure, motion, units);
  constexpr double narrowest = 0.005;  // of the figure, to be seen
  for (const auto& [from, to] : motion.sticks) {
    if (to - from >= narrowest * motion.shown_to) {
      figure.add_band("held", from * units.time, to * units.time, Ink::grey);
    }
  }
  if (motion.beta) {
    add_limits(figure, motion, units);
  }
  for (const OtherMotion& other : motion.others) {
    if (!is_drawn(motion, other)) {
      const auto [low, high] = other.reach;
      figure.clauses.push_back(format("{} it would reach {}, beyond this figure", other.name,
                                      units.length_words(std::max(high, -low))));
      continue;
    }
    figure.curves.push_back(figures::line(name_of(other, figure.y, units), strokes_of(other, place),
                                          other.ink, other.dash));
  }
  if (long_one) {
    const bool rests = motion.rest.has_value();
    auto outline = crest_line(motion.states, motion.turns, 1, rests, place);
    const auto lower = crest_line(motion.states, motion.turns, -1, rests, place);
    outline.insert(outline.end(), lower.rbegin(), lower.rend());
    figure.curves.push_back({"envelope", {outline}, Ink::blue});
    figure.areas.push_back(
        {.name = "", .outline = std::move(outline), .ink = Ink::blue, .told = "envelope"});
    figure.marks.push_back(
        {"peak", {place(peak)}, figures::Shape::disc, Ink::blue, figures::Fill::hollow});
  } else {
    figure.curves.push_back({"x", {places(motion.states, place)}, Ink::blue});
  }
  mark_events(figure, motion, place, long_one ? 0 : motion.shown_to);
  if (moves) {
    figure.notes.push_back(
        {(stays ? "rest at the " : "") + peak_words + (peak.tau > 0 ? "" : " at the start"),
         place(peak)});
  }
  if (motion.rest && !(moves && stays)) {
    figure.notes.push_back(
        {format("rest {}", units.length_words(motion.rest->x)), place(*motion.rest)});
  }
  return figure;
}

}  // namespace stillpoint::report
