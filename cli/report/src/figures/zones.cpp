// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"
#include "format.hpp"

#include <algorithm>
#include <utility>

namespace stillpoint::report {

using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

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

}  // namespace stillpoint::report
