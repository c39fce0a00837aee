// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"

namespace stillpoint::report {

namespace {

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

void add_limits(Figure& figure, const DrawnMotion& motion, const FigureUnits& units) {
  std::string name = format("limit {}", units.length.words(*motion.beta));
  for (const double limit : {*motion.beta, -*motion.beta}) {
    const double y = limit * units.length;
    if (figure.y.least < y && y < figure.y.most) {
      figure.add_line(std::exchange(name, ""), {figure.level(y)}, Ink::orange, Dash::dashed, true);
    }
  }
}

/// An acceleration over the time of the motion, low below it.
Figure below_motion(const Figure& named, const auto& accelerations, std::string label, Ink ink,
                    const DrawnMotion& motion, const FigureUnits& units) {
  Points points;
  for (const auto& [tau, value] : accelerations) {
    points.push_back({tau * units.time, value});
  }
  points = thinned(points);
  const auto [least, most] = extent(points, &FigurePoint::y);
  Figure figure = over_time(named.id, named.title, motion, units);
  figure.height = 130;
  figure.below = true;
  figure.y = axis_around(std::move(label), least, most);
  figure.description = format("{}, from {:.4g} g to {:.4g} g.", named.description, least, most);
  add_lock(figure, motion, units);
  figure.curves.push_back({"", {std::move(points)}, ink});
  return figure;
}

}  // namespace

std::string beginning(const DrawnMotion& motion) {
  return motion.whole ? "" : " (beginning)";
}

Figure over_time(std::string id, const std::string& title, const DrawnMotion& motion,
                 const FigureUnits& units) {
  Figure figure{std::move(id), title + beginning(motion)};
  figure.x = {units.time_label, 0, motion.shown_to * units.time};
  return figure;
}

Figure excitation_figure(const Excitation& excitation, const DrawnMotion& motion,
                         const FigureUnits& units) {
  return below_motion({"excitation", "Excitation", "Acceleration of the base over time"},
                      design::shown_load(excitation, motion.shown_to), "base acceleration W, g",
                      Ink::purple, motion, units);
}

Figure transmitted_figure(const Excitation& excitation, const DrawnMotion& motion,
                          const FigureUnits& units) {
  return below_motion({"transmitted", "Transmitted acceleration",
                       "Acceleration of the mass over time, which the structure feels"},
                      design::shown_transmitted(motion, excitation), "acceleration, g", Ink::green,
                      motion, units);
}

Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const Place place = [&](const State& state) {
    return FigurePoint{state.tau * units.time, state.x * units.length};
  };
  const bool long_one = is_long(motion);
  const State& peak = motion.farthest();
  const std::string peak_words = "peak " + units.length.words(peak.x);
  const std::string rest_words = words_of_rest(motion, units);
  Figure figure = over_time("motion", "Motion", motion, units);
  figure.y = displacement_axis(motion, units);
  const bool moves = motion.moves();
  const bool stays = motion.rest && design::is_as_far(*motion.rest, peak);
  const std::string mass = motion.with.empty() ? "The mass" : motion.with + "the mass";
  figure.clauses = {(!moves  ? mass + " does not move"
                     : stays ? format("{} {} and stays there", mass, reached(peak, units))
                             : format("{} {} and is {}", mass, reached(peak, units), rest_words)) +
                    (long_one ? ", swinging within the shaded envelope" : "") +
                    (motion.locked_to ? format(", locked to {}, beyond this figure",
                                               units.time_words(*motion.locked_to))
                                      : "")};
  figure.description = "Displacement over time. " + figure.caption();
  add_zones(figure, motion, units, Along::x);
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
  add_others(figure, motion, place, units);
  if (long_one) {
    const auto crests = [&](double side) {
      return places(design::crests(motion.states, motion.turns, side, motion.rest.has_value()),
                    place);
    };
    Points outline = between(crests(1), crests(-1));
    figure.curves.push_back({"envelope", {outline}, Ink::blue});
    figure.areas.push_back(
        {.name = "", .outline = std::move(outline), .ink = Ink::blue, .told = "envelope"});
    figure.marks.push_back({"peak", {place(peak)}, Shape::disc, Ink::blue, Fill::hollow});
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
