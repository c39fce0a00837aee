// SPDX-License-Identifier: MIT
#include "figures/lines.hpp"
#include "figures/motion_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace stillpoint::report {

using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// Between two states on the same side of every edge, without the notch's.
double friction_between(const DrawnMotion& motion, const State& one, const State& other) {
  const double middle = std::abs(one.x + other.x) / 2;
  for (const FrictionZone& zone : motion.surface.zones) {
    if (middle < zone.to) {
      return zone.f;
    }
  }
  return motion.oscillator.f;
}

/// "12 kJ", a part of a whole.
std::string part_words(double part, double whole, const FigureUnits& units) {
  return part <= 0 ? "nothing" : part < 1e-3 * whole ? "less than 0.1 %" : units.energy.words(part);
}

}  // namespace

Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const double p = motion.oscillator.p;
  const auto energy = [p](const State& state) {
    return (state.v * state.v + p * p * state.x * state.x) / 2;
  };
  const double whole = energy(motion.states.front());
  std::vector<FigurePoint> left;
  std::vector<FigurePoint> with_constant;
  std::vector<FigurePoint> all;
  double constant = 0;
  double point = 0;
  const State* before = &motion.states.front();
  for (const State& state : motion.states) {
    constant += friction_between(motion, *before, state) * std::abs(state.x - before->x);
    const double now = energy(state);
    constexpr double rounding = 1e-9;
    point = whole - now - constant;  // a free motion loses it to nothing else
    point = motion.oscillator.delta > 0 && point > rounding * whole ? point : 0;
    before = &state;
    const double tau = state.tau * units.time;
    left.push_back({tau, now * units.energy});
    with_constant.push_back({tau, (now + constant) * units.energy});
    all.push_back({tau, (now + constant + point) * units.energy});
  }
  for (std::vector<FigurePoint>* const level : {&left, &with_constant, &all}) {
    *level = thinned(*level);
  }
  const auto between = [](std::vector<FigurePoint> lower, const std::vector<FigurePoint>& upper) {
    lower.insert(lower.end(), upper.rbegin(), upper.rend());
    return lower;
  };
  const double most = std::ranges::max(all, {}, &FigurePoint::y).y;
  const std::vector<FigurePoint> nothing{{0, 0}, {left.back().x, 0}};
  Figure figure;
  figure.id = "energy";
  figure.title = "Where the energy went" + beginning(motion);
  figure.x = {units.time_label, 0, motion.shown_to * units.time};
  figure.y = {units.energy_label, 0, most > 0 ? 1.06 * most : 1};
  const double now = left.back().y / units.energy.factor;
  const std::string friction = motion.surface.zones.empty() ? "constant friction" : "friction";
  figure.clauses = {
      fmt::format("Of the energy of {} at the start, {} took {} and the notch {}",
                  units.energy.words(whole), friction, part_words(constant, whole, units),
                  part_words(point, whole, units)),
      fmt::format("{} is left {}", part_words(now, whole, units),
                  motion.rest    ? "in the spring"
                  : motion.whole ? "at the end"
                                 : "where the figure ends")};
  figure.description = figure.caption();
  figure.areas = {{"kinetic and spring", between(nothing, left), Ink::blue},
                  {constant > 0 ? friction : "", between(left, with_constant), Ink::orange},
                  {point > 0 ? "notch" : "", between(with_constant, all), Ink::green}};
  figure.curves = {{"", {left}, Ink::blue}};
  if (constant > 0) {
    figure.curves.push_back({"", {with_constant}, Ink::orange});
  }
  if (point > 0) {
    figure.curves.push_back({"", {all}, Ink::green});
  }
  return figure;
}

}  // namespace stillpoint::report
