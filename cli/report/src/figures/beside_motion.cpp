// SPDX-License-Identifier: MIT
// The motions to compare with, and the axis that they and the motion share.
#include "figures/motion_figures.hpp"

namespace stillpoint::report {

namespace {

/// Another motion is cut off at so many times the peak or the limit.
constexpr double farthest_shown = 1.4;

/// The largest |x|.
double reach(const std::vector<State>& states) {
  const auto [least, most] = extent(states, &State::x);
  return std::max(most, -least);
}

/// An envelope only if all of it is seen.
bool is_drawn(const DrawnMotion& motion, const OtherMotion& other) {
  constexpr double crossing = 3;  // times the peak: beyond that it would only cross the figure
  return !other.if_comparable ||
         reach(other.path.states) <=
             std::max((is_long(other.path) ? farthest_shown : crossing) * reach(motion.states),
                      farthest_shown * motion.beta.value_or(0));
}

/// "without friction, beyond the frame to -158 mm", if the frame cuts it off.
std::string name_of(const OtherMotion& other, const FigureAxis& axis, const FigureUnits& units) {
  const std::string name = other.name + (is_long(other.path) ? " (envelope)" : "");
  const auto [least, most] = extent(other.path.states, &State::x);
  const bool below = least * units.length < axis.least;
  const bool above = most * units.length > axis.most;
  const auto [low, high] = other.path.reach;
  return below || above ? format("{}, beyond the frame to {}", name,
                                 units.place_words(above && (!below || high > -low) ? high : low))
                        : name;
}

}  // namespace

Points places(const std::vector<State>& states, const Place& place) {
  Points points;
  points.reserve(states.size());
  std::ranges::transform(states, std::back_inserter(points), place);
  return points;
}

DrawnMotion::DrawnMotion(ShownMotion shown) : ShownMotion(std::move(shown)) {
  if (frictionless) {
    const bool slides = oscillator.f > 0 || !surface.zones.empty();
    others.push_back({.name = slides ? "without friction" : "without the notch",
                      .path = std::move(*frictionless),
                      .if_comparable = true});
  }
}

FigureAxis displacement_axis(const DrawnMotion& motion, const FigureUnits& units) {
  const std::string label = units.x_label;
  auto [least, most] = extent(motion.states, &State::x);
  if (least == most) {  // it never moves
    const double shown = motion.beta.value_or(motion.surface.notch_width.value_or(1));
    return axis_around(label, -shown * units.length, shown * units.length);
  }
  if (motion.beta) {
    least = least < 0 ? std::min(least, -*motion.beta) : 0;
    most = most > 0 ? std::max(most, *motion.beta) : 0;
  }
  constexpr double words = 0.08;  // room for the peak
  const double farthest = farthest_shown * std::max(most, -least);
  for (const OtherMotion& other : motion.others) {
    if (is_drawn(motion, other)) {
      const auto [low, high] = extent(other.path.states, &State::x);
      least = least < 0 ? std::min(least, std::max(low, -farthest)) : 0;
      most = most > 0 ? std::max(most, std::min(high, farthest)) : 0;
    }
  }
  const double room = words * (most - least);
  return axis_around(label, (least < 0 ? least - room : least) * units.length,
                     (most > 0 ? most + room : most) * units.length);
}

void add_others(Figure& figure, const DrawnMotion& motion, const Place& place,
                const FigureUnits& units) {
  for (const OtherMotion& other : motion.others) {
    const auto& [states, turns, reach] = other.path;
    if (!is_drawn(motion, other)) {
      figure.clauses.push_back(format("{} it would reach {}, beyond this figure", other.name,
                                      units.length.words(std::max(reach.high, -reach.low))));
      continue;
    }
    figure.add_line(name_of(other, figure.y, units),
                    is_long(other.path) ? Strokes{places(design::crests(states, turns, 1), place),
                                                  places(design::crests(states, turns, -1), place)}
                                        : Strokes{places(states, place)},
                    other.ink, other.dash);
  }
}

void add_zones(Figure& figure, const DrawnMotion& motion, const FigureUnits& units, Along along) {
  const FigureAxis& across = along == Along::x ? figure.y : figure.x;
  const auto strip = [&](const std::string& name, Ink ink, double from, double to) {
    from = std::max(from * units.length, across.least);
    to = std::min(to * units.length, across.most);
    if (from < to && (from > across.least || to < across.most)) {  // else it is all
      figure.areas.push_back({name,
                              along == Along::x ? rectangle(figure.x.least, figure.x.most, from, to)
                                                : Points{{from, figure.y.least},
                                                         {from, figure.y.most},
                                                         {to, figure.y.most},
                                                         {to, figure.y.least}},
                              ink});
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

void mark_events(Figure& figure, const DrawnMotion& motion, const Place& place, double last) {
  const auto mark = [&](const char* name, std::vector<State> states, const auto& are, Shape shape,
                        Ink ink, Fill fill) {
    std::erase_if(states, [&](const State& at) { return at.tau > last || !are(at); });
    figure.marks.push_back({name, places(states, place), shape, ink, fill});
  };
  const auto& width = motion.surface.notch_width;
  const auto goes_on = [&](const State& at) { return !motion.rest || at.tau != motion.rest->tau; };
  const auto at_edge = [&](const State& at) { return std::abs(at.x) == *width / 2; };
  const auto freed = [&](const State& at) { return motion.oscillator.delta > 0 && at.v == 0; };
  mark("turn", motion.turns, goes_on, Shape::disc, Ink::blue, Fill::hollow);
  if (width) {
    mark("edge of the notch", motion.states, at_edge, Shape::cross, Ink::orange, Fill::solid);
  } else {
    mark("passage", motion.passages, std::not_fn(freed), Shape::cross, Ink::orange, Fill::solid);
    mark("stopped by the notch, then freed", motion.passages, freed, Shape::diamond, Ink::orange,
         Fill::hollow);
  }
  if (motion.rest) {
    figure.marks.push_back({"rest", {place(*motion.rest)}, Shape::square, Ink::green});
  }
}

}  // namespace stillpoint::report
