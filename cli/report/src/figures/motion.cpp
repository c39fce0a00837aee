// SPDX-License-Identifier: MIT
#include "figures/other_motions.hpp"
#include "format.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace stillpoint::report {

using figures::axis_around;
using figures::Dash;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

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
  const std::string length = units.length.words(peak.x);
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

void add_limits(Figure& figure, const DrawnMotion& motion, const FigureUnits& units) {
  std::string name = format("limit {}", units.length.words(*motion.beta));
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

bool is_moving(const DrawnMotion& motion) {
  return std::ranges::any_of(motion.states,
                             [](const State& state) { return state.tau > 0 && state.v != 0; });
}

std::string beginning(const DrawnMotion& motion) {
  return motion.whole ? "" : " (beginning)";
}

Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const Place place = [&](const State& state) {
    return FigurePoint{state.tau * units.time, state.x * units.length};
  };
  const bool long_one = is_long(motion);
  const State& peak = farthest(motion);
  const std::string peak_words = "peak " + units.length.words(peak.x);
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
  add_zones(figure, motion, units.length.factor, Along::x);
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
                                      units.length.words(std::max(high, -low))));
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
        {format("rest {}", units.length.words(motion.rest->x)), place(*motion.rest)});
  }
  return figure;
}

}  // namespace stillpoint::report
