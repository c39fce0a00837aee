// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"

namespace stillpoint::report {

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
  const auto [x_least, x_most] = extent(all, &FigurePoint::x);
  const auto [v_least, v_most] = extent(all, &FigurePoint::y);
  Figure figure{"phase", "Phase portrait" + (orbit.some      ? " (some of the turns)"
                                             : orbit.repeats ? ""
                                                             : beginning(motion))};
  figure.x = axis_around(units.x_label, x_least, x_most);
  figure.y = axis_around(units.velocity_label, v_least, v_most);
  figure.description = format("Velocity over displacement, from x = {}, x' = {}.",
                              units.length.words(start.x), units.velocity.words(start.v));
  add_zones(figure, motion, units, Along::y);
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
