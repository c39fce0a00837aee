// SPDX-License-Identifier: MIT
#include "report_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace stillpoint::report {

using figures::axis_around;
using figures::Dash;
using figures::Figure;
using figures::FigureAxis;
using figures::FigureCurve;
using figures::FigurePoint;
using figures::Fill;
using figures::Ink;
using figures::Shape;

namespace {

using fmt::format;

/// More than a figure is wide.
constexpr std::size_t most_columns = 2000;
/// Marks that can still be told apart.
constexpr std::size_t most_marks = 500;

FigureAxis time_axis(const DrawnMotion& motion, const FigureUnits& units) {
  return {units.time_label, 0, motion.states.back().tau * units.time * 1.03};
}

template <class Value>
std::pair<double, double> ends(const DrawnMotion& motion, const Value& value) {
  double least = 0;
  double most = 0;
  for (const State& state : motion.states) {
    least = std::min(least, value(state));
    most = std::max(most, value(state));
  }
  return {least, most};
}

template <class Place>
std::vector<FigurePoint> places(const std::vector<State>& states, const Place& place) {
  std::vector<FigurePoint> points;
  points.reserve(states.size());
  for (const State& state : states) {
    points.push_back(place(state));
  }
  return points;
}

/// Marks of events, in the three shapes that both figures use.
template <class Place>
void mark_events(Figure& figure, const DrawnMotion& motion, const Place& place) {
  if (motion.turns.size() <= most_marks) {
    figure.marks.push_back(
        {"turn", places(motion.turns, place), Shape::disc, Ink::blue, Fill::hollow});
  }
  if (motion.passages.size() <= most_marks) {
    figure.marks.push_back({"passage", places(motion.passages, place), Shape::cross, Ink::orange});
  }
  if (motion.rest) {
    figure.marks.push_back({"rest", {place(*motion.rest)}, Shape::square, Ink::green});
  }
}

std::string beginning(const DrawnMotion& motion) {
  return motion.whole ? "" : " (beginning)";
}

}  // namespace

Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const auto place = [&](const State& state) {
    return FigurePoint{state.tau * units.time, state.x * units.length};
  };
  auto [least, most] = ends(motion, [](const State& state) { return state.x; });
  if (motion.beta) {
    least = least < 0 ? std::min(least, -*motion.beta) : 0;
    most = most > 0 ? std::max(most, *motion.beta) : 0;
  }
  Figure figure;
  figure.id = "motion";
  figure.title = "Motion" + beginning(motion);
  figure.x = time_axis(motion, units);
  figure.y = axis_around(units.x_label, least * units.length, most * units.length);
  figure.description =
      format("Displacement over time: {} turns, {} passages of x = 0{}.", motion.turns.size(),
             motion.passages.size(),
             motion.rest ? format(", at rest after {:.6g}", motion.rest->tau * units.time) : "");
  for (const auto& [from, to] : motion.sticks) {
    figure.bands.push_back({"held by friction", from * units.time, to * units.time, Ink::grey});
  }
  if (motion.beta) {
    for (const double limit : {*motion.beta, -*motion.beta}) {
      const double y = limit * units.length;
      if (figure.y.least < y && y < figure.y.most) {
        figure.curves.push_back({"largest admissible displacement β",
                                 {{{figure.x.least, y}, {figure.x.most, y}}},
                                 Ink::orange,
                                 Dash::dashed,
                                 false});
      }
    }
  }
  figure.curves.push_back({"x", {places(motion.states, place)}, Ink::blue});
  mark_events(figure, motion, place);
  return figure;
}

Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const auto place = [&](const State& state) {
    return FigurePoint{state.x * units.length, state.v * units.velocity};
  };
  const auto [x_least, x_most] = ends(motion, [](const State& state) { return state.x; });
  const auto [v_least, v_most] = ends(motion, [](const State& state) { return state.v; });
  FigureCurve arcs{"motion", {{}}, Ink::blue};
  FigureCurve jumps{"jump at x = 0", {}, Ink::orange, Dash::dotted, false};
  const State* before = nullptr;
  for (const State& state : motion.states) {
    if (before != nullptr && before->tau == state.tau && before->v != state.v) {
      jumps.strokes.push_back({place(*before), place(state)});
      arcs.strokes.emplace_back();
    }
    arcs.strokes.back().push_back(place(state));
    before = &state;
  }
  Figure figure;
  figure.id = "phase";
  figure.title = "Phase portrait" + beginning(motion);
  figure.x = axis_around(units.x_label, x_least * units.length, x_most * units.length);
  figure.y = axis_around(units.velocity_label, v_least * units.velocity, v_most * units.velocity);
  figure.description = format(
      "Velocity over displacement, from x = {:.6g}, x' = {:.6g}, with {} jumps of the velocity at "
      "x = 0.",
      motion.states.front().x * units.length, motion.states.front().v * units.velocity,
      jumps.strokes.size());
  figure.curves = {std::move(arcs)};
  if (!jumps.strokes.empty()) {
    figure.curves.push_back(std::move(jumps));
  }
  mark_events(figure, motion, place);
  return figure;
}

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
  const double end = left.back().x * 1.08;
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
  figure.description = format(
      "Of the energy {:.6g} constant friction took {:.6g} and point friction {:.6g}; {:.6g} "
      "remains.",
      all.front().y, constant * units.energy, point * units.energy, left.back().y);
  figure.areas = {
      {"remaining", between(nothing, left), Ink::blue},
      {constant > 0 ? "constant friction" : "", between(left, with_constant), Ink::orange},
      {point > 0 ? "point friction" : "", between(with_constant, all), Ink::green}};
  figure.curves = {
      {"", {left}, Ink::blue}, {"", {with_constant}, Ink::orange}, {"", {all}, Ink::green}};
  return figure;
}

namespace {

/// W at the instants that show it.
struct Wave {
  double horizon;

  std::vector<FigurePoint> operator()(const NoExcitation& /*none*/) const {
    return {{0, 0}, {horizon, 0}};
  }
  std::vector<FigurePoint> operator()(const Harmonic& wave) const {
    return sine(wave.k, wave.lambda, wave.phase, wave.duration.value_or(horizon));
  }
  std::vector<FigurePoint> operator()(const HalfSine& wave) const {
    return sine(wave.k, wave.lambda, 0, std::numbers::pi / wave.lambda);
  }
  std::vector<FigurePoint> operator()(const FullSine& wave) const {
    return sine(wave.k, wave.lambda, 0, 2 * std::numbers::pi / wave.lambda);
  }
  std::vector<FigurePoint> operator()(const Rectangle& wave) const {
    const double ends = std::numbers::pi / wave.lambda;
    return until_horizon({{0, wave.k}, {ends, wave.k}});
  }
  std::vector<FigurePoint> operator()(const Record& record) const {
    std::vector<FigurePoint> points;
    for (std::size_t i = 0; i < record.values.size(); ++i) {
      points.push_back(
          {record.times.empty() ? static_cast<double>(i) * record.step : record.times[i],
           record.values[i]});
    }
    return until_horizon(std::move(points));
  }

 private:
  [[nodiscard]] std::vector<FigurePoint> sine(double k, double lambda, double phase,
                                              double ends) const {
    const double last = std::min(ends, horizon);
    const std::int64_t count = sample_count(lambda, last);
    std::vector<FigurePoint> points;
    for (std::int64_t i = 0; i <= count; ++i) {
      const double tau = last * static_cast<double>(i) / static_cast<double>(count);
      points.push_back({tau, k * std::sin(lambda * tau + phase)});
    }
    return until_horizon(std::move(points));
  }

  /// Up to the horizon, and 0 from its own end on.
  [[nodiscard]] std::vector<FigurePoint> until_horizon(std::vector<FigurePoint> points) const {
    const auto beyond =
        std::ranges::find_if(points, [this](const FigurePoint& at) { return at.x > horizon; });
    if (beyond != points.end()) {
      if (beyond != points.begin()) {
        const FigurePoint& before = *std::prev(beyond);
        const double part = (horizon - before.x) / (beyond->x - before.x);
        *beyond = {horizon, before.y + (beyond->y - before.y) * part};
        points.erase(std::next(beyond), points.end());
        return points;
      }
      points.clear();  // a record that begins later
    }
    if (points.empty() || points.back().x < horizon) {
      const double since = points.empty() ? 0 : points.back().x;
      points.push_back({since, 0});
      points.push_back({horizon, 0});
    }
    return points;
  }
};

/// The least and the largest of each column where there are more points than columns.
std::vector<FigurePoint> thinned(const std::vector<FigurePoint>& points) {
  if (points.size() <= 2 * most_columns) {
    return points;
  }
  std::vector<FigurePoint> kept;
  const std::size_t step = (points.size() + most_columns - 1) / most_columns;
  for (std::size_t first = 0; first < points.size(); first += step) {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end =
        points.begin() + static_cast<std::ptrdiff_t>(std::min(first + step, points.size()));
    auto [least, most] = std::ranges::minmax_element(begin, end, {}, &FigurePoint::y);
    if (most < least) {
      std::swap(least, most);
    }
    kept.push_back(*least);
    if (most != least) {
      kept.push_back(*most);
    }
  }
  return kept;
}

}  // namespace

Figure excitation_figure(const Excitation& excitation, const DrawnMotion& motion,
                         const FigureUnits& units) {
  std::vector<FigurePoint> points = thinned(std::visit(Wave{motion.states.back().tau}, excitation));
  double least = 0;
  double most = 0;
  for (FigurePoint& at : points) {
    at.x *= units.time;
    least = std::min(least, at.y);
    most = std::max(most, at.y);
  }
  Figure figure;
  figure.id = "excitation";
  figure.title = "Excitation" + beginning(motion);
  figure.x = time_axis(motion, units);
  figure.y = axis_around("base acceleration W, g", least, most);
  figure.description =
      format("Acceleration of the base over time, from {:.6g} g to {:.6g} g.", least, most);
  figure.curves.push_back({"W", {std::move(points)}, Ink::purple});
  return figure;
}

}  // namespace stillpoint::report
