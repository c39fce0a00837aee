// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"
#include "format.hpp"

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::axis_around;
using figures::Dash;
using figures::Figure;
using figures::FigurePoint;
using figures::Ink;

namespace {

/// One side of a motion, the farthest point in each column of time, in `x` and upwards.
using Side = std::vector<FigurePoint>;

/// Raises what lies between two crests, each the highest in a swing to either side, to the line
/// from one to the next, before the first to that from the start of the motion, and behind the last
/// if the motion goes on to its height.
void join_crests(Side& side, const FigurePoint& start, double column, std::size_t swing,
                 bool rests) {
  const Side own = side;
  const auto raise = [&](std::size_t from, std::size_t to, const FigurePoint& first,
                         const FigurePoint& last) {
    const auto height = [&](double x) {
      return std::lerp(first.y, last.y, (x - first.x) / (last.x - first.x));
    };
    for (std::size_t i = from; i < to; ++i) {
      if (own[i].y < height(own[i].x)) {
        const double middle = column * (static_cast<double>(i) + 0.5);
        side[i] = {middle, height(middle)};
      }
    }
  };
  auto from = static_cast<std::size_t>(start.x / column);
  FigurePoint before = start;
  for (std::size_t i = from; i + swing < own.size(); ++i) {
    const std::size_t first = i - std::min(i, swing);
    if (own[i].y >=
        std::ranges::max(std::span(own).subspan(first, 2 * swing + 1), {}, &FigurePoint::y).y) {
      raise(from, i, before, own[i]);
      from = i + 1;
      before = own[i];
    }
  }
  if (!rests) {
    raise(from, own.size(), before, {before.x + 1, before.y});
  }
}

/// Around the motion, in the order of an outline, from its crests to either side in columns of
/// time. A rest of many columns is one line between two points.
std::vector<FigurePoint> envelope(const std::vector<FigurePoint>& points, std::size_t turns,
                                  double last_turn, bool rests) {
  constexpr std::size_t columns = 180;
  const double end = points.back().x;
  const double width = end / columns;
  Side above(columns, {0, -HUGE_VAL});
  Side below = above;
  const auto column = [&](const FigurePoint& at) {
    return std::min(static_cast<std::size_t>(at.x / end * columns), columns - 1);
  };
  const auto include = [&](std::size_t i, const FigurePoint& at) {
    const double left = width * static_cast<double>(i);
    const double x = std::clamp(at.x, left, left + width);
    above[i] = at.y > above[i].y ? FigurePoint{x, at.y} : above[i];
    below[i] = -at.y > below[i].y ? FigurePoint{x, -at.y} : below[i];
  };
  const FigurePoint* before = &points.front();
  for (const FigurePoint& at : points) {
    for (std::size_t i = column(*before); i <= column(at); ++i) {
      include(i, *before);
      include(i, at);
    }
    before = &at;
  }
  const auto swing =
      static_cast<std::size_t>(std::lround(last_turn / width / static_cast<double>(turns)));
  const FigurePoint& first = points.front();
  const FigurePoint start = *std::prev(std::ranges::find_if(
      points, [&](const FigurePoint& at) { return at.y != first.y; }));  // the last that is held
  join_crests(above, start, width, swing, rests);
  join_crests(below, {start.x, -start.y}, width, swing, rests);
  std::vector<FigurePoint> outline{first};
  outline.reserve(2 * columns + 4);
  outline.insert(outline.end(), above.begin(), above.end());
  outline.push_back({end, above.back().y});
  outline.push_back({end, -below.back().y});
  for (std::size_t i = columns; i-- > 0;) {
    outline.push_back({below[i].x, -below[i].y});
  }
  outline.push_back(first);
  return outline;
}

std::string count_of(const std::vector<State>& events, std::string_view one) {
  return plural(static_cast<double>(events.size()), one);
}

constexpr double rounding = 1 - 1e-12;

/// The first of the farthest: what rests there may be drawn a last digit farther out later on.
const State& farthest(const DrawnMotion& motion) {
  const auto distance = [](const State& state) { return std::abs(state.x); };
  const double most = distance(*std::ranges::max_element(motion.states, {}, distance));
  return *std::ranges::find_if(
      motion.states, [&](const State& state) { return distance(state) >= most * rounding; });
}

/// "starts at its peak of 0.5" or "reaches its peak of 137 mm after 0.585 s".
std::string reached(const State& peak, const FigureUnits& units) {
  const std::string length = units.length_words(peak.x);
  return peak.tau > 0
             ? format("reaches its peak of {} after {}", length, units.time_words(peak.tau))
             : format("starts at its peak of {}", length);
}

/// "at rest at x = 4.46 mm, inside the notch, after 1.53 s".
std::string words_of_rest(const DrawnMotion& motion, const FigureUnits& units) {
  if (!motion.rest) {
    return format("{} {}", motion.states.back().v == 0 ? "at rest" : "still moving",
                  motion.whole ? "at the end" : "where the figure ends");
  }
  const double x = motion.rest->x;
  const bool inside = x != 0 && 2 * std::abs(x) <= motion.surface.notch_width.value_or(0);
  return format("at rest at x = {}{} after {}", units.place_words(x),
                inside ? ", inside the notch," : "", units.time_words(motion.rest->tau));
}

bool is_long(const OtherMotion& other) {
  return other.turns.size() > most_single_half_cycles;
}

/// The largest |x|.
double reach(const std::vector<State>& states) {
  const auto [least, most] = extent(states, &State::x);
  return std::max(most, -least);
}

/// Another motion is cut off at so many times the peak or the limit.
constexpr double farthest_shown = 1.4;

/// Whether another motion is drawn; an envelope only if all of it is seen.
bool is_drawn(const DrawnMotion& motion, const OtherMotion& other) {
  constexpr double crossing = 3;  // times the peak: beyond that it would only cross the figure
  return !other.if_comparable ||
         reach(other.states) <=
             std::max((is_long(other) ? farthest_shown : crossing) * reach(motion.states),
                      farthest_shown * motion.beta.value_or(0));
}

/// Up to the motion and the limit, and to the motion without friction if that is not much larger.
figures::FigureAxis displacement_axis(const DrawnMotion& motion, const FigureUnits& units) {
  auto [least, most] = extent(motion.states, &State::x);
  if (least == most) {  // it never moves
    const double shown = motion.beta.value_or(motion.surface.notch_width.value_or(1));
    return axis_around(units.x_label, -shown * units.length, shown * units.length);
  }
  if (motion.beta) {
    least = least < 0 ? std::min(least, -*motion.beta) : 0;
    most = most > 0 ? std::max(most, *motion.beta) : 0;
  }
  constexpr double words = 0.08;  // room for the peak
  const double largest = std::max(most, -least);
  for (const OtherMotion& other : motion.others) {
    if (!is_drawn(motion, other)) {
      continue;
    }
    for (const State& state : other.states) {
      least = least < 0 ? std::min(least, std::max(state.x, -farthest_shown * largest)) : 0;
      most = most > 0 ? std::max(most, std::min(state.x, farthest_shown * largest)) : 0;
    }
  }
  const double room = words * (most - least);
  return axis_around(units.x_label, (least < 0 ? least - room : least) * units.length,
                     (most > 0 ? most + room : most) * units.length);
}

/// The least and the largest x of another motion.
Interval whole_reach(const OtherMotion& other) {
  return other.reach.value_or(extent(other.states, &State::x));
}

/// "without friction, beyond the frame to -158 mm", if the frame cuts it off.
std::string name_of(const OtherMotion& other, const figures::FigureAxis& axis,
                    const FigureUnits& units) {
  const std::string name = other.name + (is_long(other) ? " (envelope)" : "");
  const auto [least, most] = extent(other.states, &State::x);
  const bool below = least * units.length < axis.least;
  const bool above = most * units.length > axis.most;
  const auto [low, high] = whole_reach(other);
  return below || above ? format("{}, beyond the frame to {}", name,
                                 units.place_words(above && (!below || high > -low) ? high : low))
                        : name;
}

/// Of one with too many half-cycles to be told apart the lines through its crests.
template <class Place>
std::vector<std::vector<FigurePoint>> strokes_of(const OtherMotion& other, const Place& place) {
  std::vector<FigurePoint> points = places(other.states, place);
  if (!is_long(other)) {
    return {std::move(points)};
  }
  const auto outline = envelope(points, other.turns.size(), place(other.turns.back()).x, false);
  const auto lower = outline.begin() + static_cast<std::ptrdiff_t>(outline.size() / 2);
  return {{outline.begin(), lower}, {lower, outline.end()}};
}

void add_limits(Figure& figure, const DrawnMotion& motion, const FigureUnits& units) {
  std::string name = format("limit {}", units.length_words(*motion.beta));
  for (const double limit : {*motion.beta, -*motion.beta}) {
    const double y = limit * units.length;
    if (figure.y.least < y && y < figure.y.most) {
      figure.curves.push_back({.name = std::exchange(name, ""),
                               .strokes = {{{figure.x.least, y}, {figure.x.most, y}}},
                               .ink = Ink::orange,
                               .dash = Dash::dashed,
                               .hover = false,
                               .labelled = true});
    }
  }
}

}  // namespace

bool is_moving(const DrawnMotion& motion) {
  return std::ranges::any_of(motion.states,
                             [](const State& state) { return state.tau > 0 && state.v != 0; });
}

std::string beginning(const DrawnMotion& motion) {
  return motion.whole ? "" : " (beginning)";
}

void add_zones(Figure& figure, const DrawnMotion& motion, double length, Along along) {
  const auto strip = [&](const std::string& name, Ink ink, double from, double to) {
    const figures::FigureAxis& long_way = along == Along::x ? figure.x : figure.y;
    const figures::FigureAxis& across = along == Along::x ? figure.y : figure.x;
    from = std::max(from * length, across.least);
    to = std::min(to * length, across.most);
    if (from < to && (from > across.least || to < across.most)) {  // else it is all
      std::vector<FigurePoint> outline{
          {long_way.least, from}, {long_way.most, from}, {long_way.most, to}, {long_way.least, to}};
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
  if (motion.locked_from) {
    const double from = *motion.locked_from;
    const std::string to =
        motion.locked_to ? " to " + units.time_words(*motion.locked_to) : std::string();
    figure.bands.push_back(
        {(from == 0 ? "locked throughout" : "locked from " + units.time_words(from)) + to,
         from * units.time, figure.x.most, Ink::amber});
  }
}

Figure motion_figure(const DrawnMotion& motion, const FigureUnits& units) {
  const auto place = [&](const State& state) {
    return FigurePoint{state.tau * units.time, state.x * units.length};
  };
  const bool long_one = is_long(motion);
  const State& peak = farthest(motion);
  const std::string peak_words = "peak " + units.length_words(peak.x);
  const std::string rest_words = words_of_rest(motion, units);
  Figure figure;
  figure.id = "motion";
  figure.title = "Motion" + beginning(motion);
  figure.x = {units.time_label, 0, motion.shown_to * units.time};
  figure.y = displacement_axis(motion, units);
  figure.description =
      format("Displacement over time: {}, {}, {} of x = 0, {}.", peak_words,
             count_of(motion.turns, "turn"), count_of(motion.passages, "passage"), rest_words);
  const bool moves = is_moving(motion);
  const bool stays = motion.rest && std::abs(motion.rest->x) >= std::abs(peak.x) * rounding;
  const std::string mass = motion.with.empty() ? "The mass" : motion.with + "the mass";
  figure.caption = !moves  ? mass + " does not move."
                   : stays ? format("{} {} and stays there.", mass, reached(peak, units))
                           : format("{} {} and is {}.", mass, reached(peak, units), rest_words);
  add_zones(figure, motion, units.length, Along::x);
  add_lock(figure, motion, units);
  constexpr double narrowest = 0.005;  // of the figure, to be seen
  for (const auto& [from, to] : motion.sticks) {
    if (to - from >= narrowest * motion.shown_to) {
      figure.bands.push_back({"held", from * units.time, to * units.time, Ink::grey});
    }
  }
  if (motion.beta) {
    add_limits(figure, motion, units);
  }
  std::string beyond = motion.locked_to ? format(", locked to {}, beyond this figure",
                                                 units.time_words(*motion.locked_to))
                                        : "";
  for (const OtherMotion& other : motion.others) {
    if (!is_drawn(motion, other)) {
      const auto [low, high] = whole_reach(other);
      beyond += format("; {} it would reach {}, beyond this figure", other.name,
                       units.length_words(std::max(high, -low)));
      continue;
    }
    figure.curves.push_back({.name = name_of(other, figure.y, units),
                             .strokes = strokes_of(other, place),
                             .ink = other.ink,
                             .dash = other.dash,
                             .hover = false});
  }
  if (long_one) {
    auto outline = envelope(places(motion.states, place), motion.turns.size(),
                            place(motion.turns.back()).x, motion.rest.has_value());
    figure.curves.push_back({"envelope", {outline}, Ink::blue});
    figure.areas.push_back(
        {.name = "", .outline = std::move(outline), .ink = Ink::blue, .told = "envelope"});
    beyond = ", swinging within the shaded envelope" + beyond;
    figure.marks.push_back(
        {"peak", {place(peak)}, figures::Shape::disc, Ink::blue, figures::Fill::hollow});
  } else {
    figure.curves.push_back({"x", {places(motion.states, place)}, Ink::blue});
  }
  figure.caption.insert(figure.caption.size() - 1, beyond);
  mark_events(figure, motion, place, long_one ? 0 : motion.shown_to);
  if (long_one && motion.rest) {
    figure.marks.push_back({"rest", {place(*motion.rest)}, figures::Shape::square, Ink::green});
  }
  if (moves) {
    figure.notes.push_back(
        {(stays ? "rest at the " : "") + peak_words + (peak.tau > 0 ? "" : " at the start"),
         place(peak)});
  }
  if (motion.rest && !(moves && stays)) {
    figure.notes.push_back(
        {format("rest {}", units.length_words(motion.rest->x)), place(*motion.rest)});
  }
  return figure;
}

}  // namespace stillpoint::report
