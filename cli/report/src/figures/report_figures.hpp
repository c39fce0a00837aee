// SPDX-License-Identifier: MIT
#pragma once

// The data drawn for a motion, a region and a sweep, and their figures.

#include "units.hpp"

#include <stillpoint/core/state.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/design/pulse.hpp>
#include <stillpoint/design/region.hpp>
#include <stillpoint/design/shown_motion.hpp>
#include <stillpoint/design/spectrum.hpp>
#include <stillpoint/design/works_for.hpp>
#include <stillpoint/figures/figure.hpp>
#include <stillpoint/sweep/map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

/// States as points.
template <class Place>
std::vector<figures::FigurePoint> places(const std::vector<State>& states, const Place& place) {
  std::vector<figures::FigurePoint> points;
  points.reserve(states.size());
  for (const State& state : states) {
    points.push_back(place(state));
  }
  return points;
}

/// From the least value to the largest, 0 included.
template <class Item>
Interval extent(const std::vector<Item>& items, double Item::*value) {
  Interval seen{0, 0};
  for (const Item& item : items) {
    seen = {std::min(seen.low, item.*value), std::max(seen.high, item.*value)};
  }
  return seen;
}

/// The least and the largest of each column and both ends, if there are more points than columns.
[[nodiscard]] std::vector<figures::FigurePoint> thinned(
    const std::vector<figures::FigurePoint>& points);

/// A line through value(x), which is empty where it ends.
template <class Value>
std::vector<std::vector<figures::FigurePoint>> line_over(const std::vector<double>& places,
                                                         const Value& value) {
  std::vector<std::vector<figures::FigurePoint>> strokes{{}};
  for (const double x : places) {
    if (const std::optional<double> y = value(x)) {
      strokes.back().push_back({x, *y});
    } else if (!strokes.back().empty()) {
      strokes.emplace_back();
    }
  }
  std::erase_if(strokes, [](const auto& stroke) { return stroke.empty(); });
  return strokes;
}
/// Evenly spaced.
[[nodiscard]] std::vector<double> evenly(double from, double to, int count);

/// Another motion from the same start, to compare with.
struct OtherMotion {
  std::string name;
  std::vector<State> states;
  Interval reach{};  ///< of x, also where it goes on beyond what is drawn
  figures::Ink ink{figures::Ink::grey};
  figures::Dash dash{figures::Dash::dotted};
  std::vector<State> turns{};  ///< of one that may be drawn as its envelope
  bool if_comparable{false};   ///< drawn only if it would not just cross the figure
};

/// A motion and what is drawn with it.
struct DrawnMotion : design::ShownMotion {
  std::vector<OtherMotion> others;  ///< those that do not hide it
  std::optional<double> beta;
  std::string with;  ///< "With the strongest hit, ", if it is one of several

  explicit DrawnMotion(ShownMotion shown);
};

/// With more half-cycles than can be distinguished, the envelope is drawn. A load turns the mass
/// several times in some of them.
inline constexpr std::size_t most_single_half_cycles = 40;
[[nodiscard]] inline bool is_long(const DrawnMotion& motion) {
  constexpr std::size_t most_turns = 3 * most_single_half_cycles;
  return motion.passages.size() > most_single_half_cycles || motion.turns.size() > most_turns;
}

/// Adds another motion to compare with, as far as the figure goes; only if it can be told apart.
void add(DrawnMotion& motion, OtherMotion other);
void add_if_visible(DrawnMotion& motion, OtherMotion other);

/// Whether it moves at all: a load may be too weak.
[[nodiscard]] bool is_moving(const DrawnMotion& motion);
/// " (beginning)" for a motion that is not drawn whole.
[[nodiscard]] std::string beginning(const DrawnMotion& motion);
/// Marks of events: turns and passages up to a tau, and the rest.
template <class Place>
void mark_events(figures::Figure& figure, const DrawnMotion& motion, const Place& place,
                 double last) {
  const auto those = [&](std::vector<State> states, const auto& are) {
    std::erase_if(states, [&](const State& at) { return at.tau > last || !are(at); });
    return places(states, place);
  };
  using figures::Fill;
  using figures::Ink;
  using figures::Shape;
  const auto goes_on = [&](const State& at) { return !motion.rest || at.tau != motion.rest->tau; };
  const auto& width = motion.surface.notch_width;
  const bool acts = motion.oscillator.delta > 0 && !width;
  const auto freed = [&](const State& at) { return acts && at.v == 0; };
  figure.marks.push_back(
      {"turn", those(motion.turns, goes_on), Shape::disc, Ink::blue, Fill::hollow});
  if (width) {
    const auto at_edge = [&](const State& at) { return std::abs(at.x) == *width / 2; };
    figure.marks.push_back(
        {"edge of the notch", those(motion.states, at_edge), Shape::cross, Ink::orange});
  } else {
    figure.marks.push_back(
        {"passage", those(motion.passages, std::not_fn(freed)), Shape::cross, Ink::orange});
    figure.marks.push_back({"stopped by the notch, then freed", those(motion.passages, freed),
                            Shape::diamond, Ink::orange, Fill::hollow});
  }
  if (motion.rest) {
    figure.marks.push_back({"rest", {place(*motion.rest)}, Shape::square, Ink::green});
  }
}

/// The notch with a width and the zones of other friction, as strips along an axis.
enum class Along { x, y };
void add_zones(figures::Figure& figure, const DrawnMotion& motion, double length, Along along);

/// The time from which the mass is locked, shaded.
void add_lock(figures::Figure& figure, const DrawnMotion& motion, const FigureUnits& units);

[[nodiscard]] figures::Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units);
[[nodiscard]] figures::Figure phase_figure(const DrawnMotion& motion, const FigureUnits& units);
/// For a free motion: the energy left, and what each friction took.
[[nodiscard]] figures::Figure energy_figure(const DrawnMotion& motion, const FigureUnits& units);
/// W over the same time as the motion.
[[nodiscard]] figures::Figure excitation_figure(const Excitation& excitation,
                                                const DrawnMotion& motion,
                                                const FigureUnits& units);

/// A point of the (f, Delta) plane and its tolerance.
struct DrawnDamper {
  std::string name;
  double f{0};
  double delta{0};
  double tolerance{0};
  bool admissible{true};
};

/// Whether it is in the region, even if it keeps less than the tolerance asked for.
[[nodiscard]] inline bool is_within(const DrawnDamper& damper) {
  return damper.admissible || damper.tolerance > 0;
}

/// A part of the plane is enlarged in a corner, unless rounding would be seen.
void add_inset(figures::Figure& figure, const figures::FigurePoint& low,
               const figures::FigurePoint& high);
/// Enlarges a box if it is too small to see, unless it is one of next to nothing.
void add_box_inset(figures::Figure& figure, const std::vector<figures::FigurePoint>& box);
/// Adds to the caption of a region which part of it is enlarged, if any.
void caption_inset(figures::Figure& figure, const FigureUnits& units);
/// The corners of its tolerance box, starting from the lower left.
[[nodiscard]] std::vector<figures::FigurePoint> tolerance_box(const DrawnDamper& damper,
                                                              const design::BoxShape& shape,
                                                              double unit);
/// "tolerance ±34.2 %", or that of f and of Delta.
[[nodiscard]] std::string tolerance_words(const design::BoxShape& shape, double tolerance);

/// The damper with its box, enlarged if it is small.
void add_damper(figures::Figure& figure, const DrawnDamper& damper, const design::BoxShape& shape,
                const FigureUnits& units);
/// What the box means, or without one the area that is left, for a caption to go on.
[[nodiscard]] std::string region_clause(const std::optional<DrawnDamper>& damper,
                                        const design::Region& region, const design::Limits& limits);

/// What to draw for a region.
struct DrawnRegion {
  design::Problem problem;
  design::Limits limits;
  design::Region region;
  std::optional<DrawnDamper> damper;
  std::string mend;  ///< the title where nothing is admissible
  std::optional<design::PulseProblem> pulse{};
  std::vector<Interval> intervals{};  ///< of f that are admissible under it
};

/// A line around each.
void add_tolerant(figures::Figure& figure, const design::Limits& limits,
                  std::vector<std::vector<figures::FigurePoint>> areas);
/// Of a stop at that arrival, in each figure; those of neighbours differ.
[[nodiscard]] figures::Ink arrival_ink(double arrival);
/// "arrivals 3, 6, 9": those of `arrivals` that have the ink of `one`; empty if it is the only one.
[[nodiscard]] std::string key_of_arrivals(const std::set<double>& arrivals, double one);
/// The admissible region in the (f, Delta) plane, its forbidden sides in words, and a point in it.
[[nodiscard]] figures::Figure region_figure(const DrawnRegion& drawn, const FigureUnits& units);

/// Where the mass stops, by the velocity of the hit, and which of them the damper works for.
[[nodiscard]] figures::Figure hits_figure(const design::Problem& problem,
                                          const design::Limits& limits, double f, double delta,
                                          const std::optional<design::WorksFor>& works_for,
                                          const FigureUnits& units);
/// The same by the strength of a pulse, at the first return.
[[nodiscard]] figures::Figure strengths_figure(const design::PulseProblem& problem, double f,
                                               double delta,
                                               const std::optional<design::WorksFor>& works_for);

/// The analytic boundaries alone, within the axes of the figure.
void add_boundaries(figures::Figure& figure, const design::Problem& problem,
                    const FigureUnits& units, const figures::FigurePoint& last);

/// Transmitted acceleration, peak and residual over the period, with the notch and without; for a
/// design, `chosen` is its p, which is marked.
[[nodiscard]] std::vector<figures::Figure> spectrum_figures(
    const design::Spectrum& spectrum, const FigureUnits& units,
    const std::optional<double>& chosen = std::nullopt);

/// The plane of f and Delta, coloured by how the motions end and after how many half-cycles; of
/// free motions from x = 0 with the analytic boundaries on top.
[[nodiscard]] figures::Figure sweep_figure(const sweep::SweepSpec& spec,
                                           const sweep::SweepMap& map);

}  // namespace stillpoint::report
