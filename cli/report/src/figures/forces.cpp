// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"

namespace stillpoint::report {

using design::ShownForce;

namespace {

FigureCurve curve_of(std::string name, const std::vector<std::vector<ShownForce>>& arcs,
                     double ShownForce::*force, const FigureUnits& units, Ink ink) {
  FigureCurve curve{.name = std::move(name), .strokes = {}, .ink = ink};
  for (const std::vector<ShownForce>& arc : arcs) {
    curve.strokes.emplace_back();
    for (const ShownForce& now : arc) {
      curve.strokes.back().push_back({now.x * units.length, now.*force * units.force});
    }
  }
  return curve;
}

double largest(const std::vector<ShownForce>& all, double ShownForce::*force) {
  const auto [least, most] = extent(all, force);
  return std::max(most, -least);
}

}  // namespace

Figure loop_figure(const Excitation& excitation, const DrawnMotion& motion,
                   const FigureUnits& units) {
  const design::ShownOrbit orbit = design::shown_orbit(motion);
  std::vector<std::vector<ShownForce>> arcs;
  for (const std::vector<State>& arc : orbit.arcs) {
    arcs.push_back(design::shown_forces(motion, excitation, arc));
  }
  std::erase_if(arcs, [](const auto& arc) { return arc.empty(); });
  const bool damped = motion.oscillator.zeta > 0;
  const std::string damper = damped ? "friction and damping" : "friction";
  FigureCurve whole = curve_of("with the spring", arcs, &ShownForce::whole, units, Ink::blue);
  FigureCurve part = curve_of(damper, arcs, &ShownForce::damper, units, Ink::orange);
  part.directed = true;
  const Points places = joined(whole.strokes);
  const auto all = design::shown_forces(motion, excitation, motion.states);
  const double most = std::max(largest(all, &ShownForce::whole), largest(all, &ShownForce::damper));
  const auto [x_least, x_most] = extent(places, &FigurePoint::x);
  Figure figure{"loop", "Force and displacement" + (orbit.some      ? " (some of the turns)"
                                                    : orbit.repeats ? ""
                                                                    : beginning(motion))};
  figure.x = axis_around(units.x_label, x_least, x_most);
  figure.y = axis_around(units.force_label, -most * units.force, most * units.force);
  const auto words = [&](double ShownForce::*force) {
    return units.force.words(largest(all, force)) +
           (units.force.name.empty() ? " of the weight" : "");
  };
  const double delta = motion.oscillator.delta;
  figure.clauses = {
      format("{} {} up to {}, with the spring up to {}",
             damped ? "Friction and damping" : "Friction", damped ? "resist with" : "resists with",
             words(&ShownForce::damper), words(&ShownForce::whole)),
      delta > 0 && !motion.surface.notch_width
          ? format("at x = 0 the notch takes {} a passage besides, all at once",
                   units.energy.words(delta))
          : ""};
  figure.description = "Force over displacement. " + figure.caption();
  add_zones(figure, motion, units, Along::y);
  figure.curves = {std::move(part), std::move(whole)};
  return figure;
}

Figure transmitted_figure(const Excitation& excitation, const DrawnMotion& motion,
                          const FigureUnits& units) {
  Points points;
  for (const auto& [tau, felt] : design::shown_transmitted(motion, excitation)) {
    points.push_back({tau * units.time, felt});
  }
  points = thinned(points);
  Figure figure = over_time("transmitted", "Transmitted acceleration", motion, units);
  figure.height = 130;
  figure.below = true;
  const auto [least, most] = extent(points, &FigurePoint::y);
  figure.y = axis_around("acceleration, g", least, most);
  figure.description = format(
      "Acceleration of the mass over time, which the structure feels, from {:.4g} g to "
      "{:.4g} g.",
      least, most);
  add_lock(figure, motion, units);
  figure.curves.push_back({"", {std::move(points)}, Ink::green});
  return figure;
}

}  // namespace stillpoint::report
