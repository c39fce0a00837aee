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

/// Of the points in the plane of displacement and what `y` bounds.
Figure orbit_figure(std::string id, const std::string& title, const design::ShownOrbit& orbit,
                    const DrawnMotion& motion, const Points& points, const FigureUnits& units,
                    std::string y_label, const Interval& y) {
  Figure figure{std::move(id), title + (orbit.some      ? " (some of the turns)"
                                        : orbit.repeats ? ""
                                                        : beginning(motion))};
  const auto [least, most] = extent(points, &FigurePoint::x);
  figure.x = axis_around(units.x_label, least, most);
  figure.y = axis_around(std::move(y_label), y.low, y.high);
  add_zones(figure, motion, units, Along::y);
  return figure;
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
  const auto all = design::shown_forces(motion, excitation, motion.states);
  const double most = std::max(largest(all, &ShownForce::whole), largest(all, &ShownForce::damper));
  Figure figure =
      orbit_figure("loop", "Force and displacement", orbit, motion, joined(whole.strokes), units,
                   units.force_label, {-most * units.force, most * units.force});
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
  figure.curves = {std::move(part), std::move(whole)};
  return figure;
}

Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const Place place = [&](const State& state) {
    return FigurePoint{state.x * units.length, state.v * units.velocity};
  };
  const design::ShownOrbit orbit = design::shown_orbit(motion);
  const State& start = orbit.arcs.front().front();
  FigureCurve arcs{.name = "motion", .strokes = {}, .ink = Ink::blue, .directed = true};
  for (const std::vector<State>& arc : orbit.arcs) {
    arcs.strokes.push_back(places(arc, place));
  }
  const Points all = joined(arcs.strokes);
  FigureCurve jumps{"jump at x = 0", {}, Ink::orange, Dash::dotted, false};
  double largest_jump = 0;
  for (const auto& [from, to] : orbit.jumps) {
    jumps.strokes.push_back({place(from), place(to)});
    largest_jump = std::max(largest_jump, std::abs(to.v - from.v) * units.velocity);
  }
  const auto [v_least, v_most] = extent(all, &FigurePoint::y);
  Figure figure = orbit_figure("phase", "Phase portrait", orbit, motion, all, units,
                               units.velocity_label, {v_least, v_most});
  figure.description = format("Velocity over displacement, from x = {}, x' = {}.",
                              units.length.words(start.x), units.velocity.words(start.v));
  figure.curves = {std::move(arcs)};
  constexpr double visible = 0.01;  // of the height, some pixels
  if (largest_jump > visible * (v_most - v_least)) {
    figure.clauses = {"At x = 0 the velocity jumps because the notch takes energy"};
    figure.curves.push_back(std::move(jumps));
  } else if (!jumps.strokes.empty()) {
    figure.clauses = {
        "The notch takes energy at x = 0, where the jump of the velocity is too small to see"};
  } else if (motion.surface.notch_width) {
    figure.clauses = {format(
        "The notch takes energy over its width{}",
        start.x == 0 && start.v != 0 ? ", but none when the hit moves the mass out of it" : "")};
  } else {
    figure.clauses = {!motion.surface.zones.empty() ? "The curve bends where the friction changes"
                      : motion.rest && !orbit.some  ? "The curve ends where friction holds the mass"
                      : motion.oscillator.f > 0     ? "Friction takes energy along the whole curve"
                      : motion.oscillator.zeta > 0  ? "Damping takes energy along the whole curve"
                                                    : "Nothing takes energy from the mass"};
  }
  mark_events(figure, motion, place, orbit.some ? 0 : orbit.arcs.back().back().tau);
  return figure;
}

}  // namespace stillpoint::report
