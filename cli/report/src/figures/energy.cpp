// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace stillpoint::report {

using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// Every n-th of more points than can be told apart, and the last.
void thin_out(std::vector<FigurePoint>& points) {
  constexpr std::size_t most = 1500;
  const std::size_t step = points.size() / most + 1;
  const FigurePoint last = points.back();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    points[kept++] = points[i];
  }
  points.resize(kept);
  if (step > 1) {
    points.push_back(last);
  }
}

/// "constant friction took 28 kJ and the notch 12 kJ".
std::string taken(double constant, double point, const FigureUnits& units) {
  std::string text;
  if (constant > 0) {
    text = "constant friction took " + units.energy_words(constant);
  }
  if (point > 0) {
    text += (text.empty() ? "the notch took " : " and the notch ") + units.energy_words(point);
  }
  return text;
}

}  // namespace

Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const double p = motion.oscillator.p;
  std::vector<FigurePoint> left;
  std::vector<FigurePoint> with_constant;
  std::vector<FigurePoint> all;
  double constant = 0;
  double point = 0;
  const State* before = nullptr;
  for (const State& state : motion.states) {
    const double now = (state.v * state.v + p * p * state.x * state.x) / 2;
    if (before != nullptr) {
      constant += motion.oscillator.f * std::abs(state.x - before->x);
      if (before->tau == state.tau) {
        point += (before->v * before->v - state.v * state.v) / 2;
      }
    }
    before = &state;
    const double tau = state.tau * units.time;
    left.push_back({tau, now * units.energy});
    with_constant.push_back({tau, (now + constant) * units.energy});
    all.push_back({tau, (now + constant + point) * units.energy});
  }
  for (std::vector<FigurePoint>* const level : {&left, &with_constant, &all}) {
    thin_out(*level);
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
  const double now = left.back().y / units.energy;
  const std::string took = taken(constant, point, units);
  figure.description = fmt::format("Of {} of energy, {}; kinetic and spring energy is {} {}.",
                                   units.energy_words(all.front().y / units.energy),
                                   took.empty() ? "none is lost" : took, units.energy_words(now),
                                   motion.whole ? "at the end" : "where the figure ends");
  figure.caption = figure.description;
  figure.areas = {
      {"kinetic and spring", between(nothing, left), Ink::blue},
      {constant > 0 ? "constant friction" : "", between(left, with_constant), Ink::orange},
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
