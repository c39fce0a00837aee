// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"

namespace stillpoint::report {

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
