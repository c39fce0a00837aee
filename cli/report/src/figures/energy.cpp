// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
  constexpr double seen_at_rest = 1.08;
  const double end = left.back().x * (motion.rest ? seen_at_rest : 1);
  for (std::vector<FigurePoint>* const level : {&left, &with_constant, &all}) {
    if (motion.rest) {
      level->push_back({end, level->back().y});  // what the last instant took is seen then
    }
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
  figure.x = {units.time_label, 0, end};
  figure.y = {units.energy_label, 0, most > 0 ? 1.06 * most : 1};
  const double now = left.back().y / units.energy;
  figure.description = fmt::format(
      "Of {} of energy, constant friction took {}{}; kinetic and spring energy is {} {}.",
      units.energy_words(all.front().y / units.energy), units.energy_words(constant),
      point > 0 ? " and the notch " + units.energy_words(point) : "", units.energy_words(now),
      motion.whole ? "at the end" : "where the figure ends");
  figure.caption = figure.description;
  figure.areas = {
      {"kinetic and spring", between(nothing, left), Ink::blue},
      {constant > 0 ? "constant friction" : "", between(left, with_constant), Ink::orange},
      {point > 0 ? "notch" : "", between(with_constant, all), Ink::green}};
  figure.curves = {
      {"", {left}, Ink::blue}, {"", {with_constant}, Ink::orange}, {"", {all}, Ink::green}};
  return figure;
}

}  // namespace stillpoint::report
