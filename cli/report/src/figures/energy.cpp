// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"

#include <tuple>

namespace stillpoint::report {

using design::ShownEnergy;

namespace {

/// "12 kJ", a part of a whole.
std::string taken_words(double part, double whole, const FigureUnits& units) {
  return part <= 0 ? "nothing" : part < 1e-3 * whole ? "less than 0.1 %" : units.energy.words(part);
}

}  // namespace

Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const std::vector<ShownEnergy> all = design::shown_energies(motion);
  const ShownEnergy& last = all.back();
  const double whole = all.front().left;
  const std::string friction = motion.surface.zones.empty() ? "constant friction" : "friction";
  Figure figure = over_time("energy", "Where the energy went", motion, units);
  const bool damped = motion.oscillator.zeta > 0;
  figure.clauses = {
      format("Of the energy of {} at the start, {} took {}{} and the notch {}",
             units.energy.words(whole), friction, taken_words(last.friction, whole, units),
             damped ? ", damping " + taken_words(last.damping, whole, units) : "",
             taken_words(last.notch, whole, units)),
      format("{} is left {}", taken_words(last.left, whole, units),
             motion.rest    ? "in the spring"
             : motion.whole ? "at the end"
                            : "where the figure ends")};
  figure.description = figure.caption();
  Points below{{0, 0}, {last.tau * units.time, 0}};
  std::vector<double> heights(all.size());
  for (const auto& [name, part, ink] :
       {std::tuple(std::string("kinetic and spring"), &ShownEnergy::left, Ink::blue),
        {friction, &ShownEnergy::friction, Ink::orange},
        {std::string("damping"), &ShownEnergy::damping, Ink::purple},
        {std::string("notch"), &ShownEnergy::notch, Ink::green}}) {
    if (part == &ShownEnergy::damping && !damped) {
      continue;
    }
    Points top;
    for (std::size_t i = 0; i < all.size(); ++i) {
      heights[i] += all[i].*part;
      top.push_back({all[i].tau * units.time, heights[i] * units.energy});
    }
    top = thinned(top);
    const bool any = part == &ShownEnergy::left || last.*part > 0;
    figure.areas.push_back({any ? name : "", between(std::move(below), top), ink});
    if (any) {
      figure.curves.push_back({"", {top}, ink});
    }
    below = std::move(top);
  }
  const double most = std::ranges::max(below, {}, &FigurePoint::y).y;
  figure.y = {units.energy_label, 0, most > 0 ? 1.06 * most : 1};
  return figure;
}

}  // namespace stillpoint::report
