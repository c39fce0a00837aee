// SPDX-License-Identifier: MIT
#include "figures/region_figures.hpp"
#include "figures/report_figures.hpp"
#include "figures/shading.hpp"
#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::report {

using figures::Figure;
using figures::FigureAxis;
using figures::Scale;

namespace {

using sweep::Axis;
using sweep::MapAxis;
using sweep::Quantity;
using sweep::SweepAxis;
using sweep::SweepClass;
using sweep::SweepKind;

/// Both scales have the same lightness. What never starts lies beside one half-cycle, which is
/// dark.
constexpr std::array<const char*, SweepClass::count> palette{
    "#0b4f8a", "#2f7fc1", "#6aaede", "#9ecae9", "#c6dff2", "#e6f1fa",  // at x = 0
    "#8a3b00", "#c85a00", "#ef8a2b", "#f7b267", "#fbd3a4", "#fdebd5",  // off it
    "#b8b8b8", "#000000", "#a779cc", "#f0e020", "#009e73"};

/// Off x = 0, and where it locks.
figures::Hatch hatch_of(std::size_t index) {
  using enum figures::Hatch;
  return index == SweepClass::locked                                     ? crossed
         : SweepClass::ranges <= index && index < 2 * SweepClass::ranges ? one_way
                                                                         : none;
}

/// "3", "7–15", "16 or more".
std::string count_label(std::size_t index) {
  constexpr std::size_t ranges = SweepClass::ranges;
  const std::size_t range = index % ranges;
  const int first = SweepClass::first_half_cycles.at(range);
  if (range + 1 == ranges) {
    return format("{} or more", first);
  }
  const int last = SweepClass::first_half_cycles.at(range + 1) - 1;
  return first < last ? format("{}–{}", first, last) : format("{}", first);
}

/// A mass that does not move was caught at the start of a hit, or the load never moved it.
std::string class_name(std::size_t index, bool from_rest) {
  constexpr std::size_t ranges = SweepClass::ranges;
  if (index >= 2 * ranges) {
    const std::array<const char*, 5> others{from_rest ? "stays at x = 0" : "never starts",
                                            "never stops", "not known to have stopped", "locked",
                                            "perhaps too many half-cycles"};
    return others.at(index - 2 * ranges);
  }
  return format("{} after {} half-cycle{}", index < ranges ? "centred" : "off centre",
                count_label(index), index % ranges == 0 ? "" : "s");
}

/// Where motions end alike under a load, their peaks from the smallest to the largest: yellow where
/// the notch locks, purple where they are not known to have stopped.
constexpr std::size_t peak_shades = 5;
struct ShadedClass {
  std::size_t index;
  std::string_view shades;
};
constexpr std::array shaded{
    ShadedClass{SweepClass::locked, "#8a8100#ada100#ccbf08#e8dc22#faf060"},
    ShadedClass{SweepClass::locked - 1, "#4b2a78#7550a6#9a70c4#c9aae4#e8daf5"}};

using ClassCounts = std::array<std::int64_t, SweepClass::count>;

/// Whether there is any of the classes of rests that begin at `from`.
bool any_rests(const ClassCounts& counts, std::size_t from) {
  const auto* const begin = counts.begin() + static_cast<std::ptrdiff_t>(from);
  return std::any_of(begin, begin + SweepClass::ranges,
                     [](std::int64_t count) { return count > 0; });
}

/// The key has two colours that no cell has, the shades of more than a few cells and every other
/// colour.
figures::FigureMap drawn(const sweep::SweepMap& map, const ClassCounts& counts, bool from_rest,
                         const std::string& place) {
  constexpr std::size_t ranges = SweepClass::ranges;
  const auto few = static_cast<std::int64_t>(map.cells().size() / 50);
  figures::FigureMap drawn{map.f().cells(), map.delta().cells(), map.cells(), {}, {}};
  if (any_rests(counts, 0)) {
    drawn.key.push_back({"stops " + place, "#4c96cf"});
  }
  if (any_rests(counts, ranges)) {
    drawn.key.push_back({"stops off centre", "#dc7515", hatch_of(ranges)});
  }
  for (std::size_t i = 0; i < SweepClass::count; ++i) {
    const std::string name = class_name(i, from_rest);
    drawn.palette.push_back(
        {palette.at(i), name, i < 2 * ranges ? count_label(i) : name, hatch_of(i)});
    if (counts.at(i) > (i < 2 * ranges ? few : 0)) {
      const bool locked = i == SweepClass::locked;  // in the key even if a label says so
      drawn.key.push_back(
          {locked ? format("{} {}", name, place) : name, palette.at(i), hatch_of(i)});
    }
  }
  return drawn;
}

/// In three digits; rounding beside the largest is 0.
std::string peak_words(double peak, double most, const FigureUnits& units) {
  constexpr double nothing = 1e-6;
  return format("{:.3g}{}", peak < nothing * most ? 0 : peak * units.length,
                with_blank(units.length.name));
}

/// Shades a class by its peaks, if they differ; the key says from which to which.
void shade_peaks(figures::FigureMap& drawn, const sweep::SweepMap& map, const ShadedClass& by,
                 const FigureUnits& units) {
  std::vector<double> peaks;
  for (std::size_t i = 0; i < map.peaks().size(); ++i) {
    if (map.cells()[i] == by.index) {
      peaks.push_back(map.peaks()[i]);
    }
  }
  const std::vector<double> bounds = even_bounds(std::move(peaks), 2 * peak_shades);
  if (bounds.empty() || bounds.front() == bounds.back()) {
    return;
  }
  const auto words = [&](double peak) { return peak_words(peak, bounds.back(), units); };
  const std::size_t first = drawn.palette.size();
  const std::string name = drawn.palette[by.index].name;
  const figures::Hatch hatch = hatch_of(by.index);
  for (std::size_t i = 0; i < peak_shades; ++i) {
    drawn.palette.push_back(shade(shade_of(by.shades, i), name + ", peak ",
                                  bounds[2 * i] * units.length, bounds[2 * i + 2] * units.length,
                                  units.length.name, hatch));
  }
  for (std::size_t i = 0; i < drawn.cells.size(); ++i) {
    if (map.cells()[i] == by.index) {
      drawn.cells[i] = static_cast<std::uint8_t>(first + class_of(map.peaks()[i], bounds) / 2);
    }
  }
  drawn.key.push_back(
      {format("{}, peak from {}", name, words(bounds.front())), shade_of(by.shades, 0), hatch});
  drawn.key.push_back({format("{}, peak to {}", name, words(bounds.back())),
                       shade_of(by.shades, peak_shades - 1), hatch});
}

/// From the edge of the first cell to that of the last, times a unit.
FigureAxis figure_axis(const std::string& label, const MapAxis& swept, double unit = 1) {
  const bool linear = swept.spacing() == Axis::Spacing::linear;
  const FigureAxis middles{label, unit * swept.value(0), unit * swept.value(swept.cells() - 1),
                           linear ? Scale::linear : Scale::logarithmic};
  const double half = 0.5 / static_cast<double>(swept.cells() - 1);
  return {label + (linear ? "" : " (log scale)"), middles.value(-half), middles.value(1 + half),
          middles.scale};
}

/// Of the colours that are there.
std::vector<std::string> clauses(const ClassCounts& counts, const std::string& place) {
  const bool centred = any_rests(counts, 0);
  const bool off = any_rests(counts, SweepClass::ranges);
  const bool locks = counts.at(SweepClass::locked) > 0;
  const std::string words = centred && off
                                ? format("The mass stops {} in blue areas and off centre in {}",
                                         place, locks ? "those hatched one way" : "hatched ones")
                            : centred ? format("The mass stops {} in every blue area", place)
                            : off     ? format("The mass stops off centre in every {}",
                                           locks ? "area hatched one way" : "hatched area")
                                      : "";
  std::vector<std::string> said;
  if (!words.empty()) {
    said = {words, "the darker, the fewer half-cycles it takes"};
  }
  if (locks) {
    said.push_back(
        format("{} the hatching is crossed, the notch holds the mass while the load goes on",
               said.empty() ? "Where" : "where"));
  }
  return said.empty() ? std::vector<std::string>{"No mass that moves comes to rest"} : said;
}

/// Without its unit.
double only_value(const sweep::SweepSpec& spec, Quantity quantity) {
  const double value = std::ranges::find(spec.axes, quantity, &SweepAxis::quantity)->axis[0];
  return spec.units ? spec.units->plain(quantity, value) : value;
}

}  // namespace

Figure sweep_figure(const sweep::SweepSpec& spec, const sweep::SweepMap& map) {
  // Rows are in metres, figures in millimetres.
  const FigureUnits units{.length = spec.units ? Unit{1e3, "mm"} : Unit()};
  ClassCounts counts{};
  std::ranges::for_each(map.cells(), [&counts](std::uint8_t cell) { ++counts.at(cell); });
  const double v0 = std::abs(only_value(spec, Quantity::v0));
  const std::string place = given(spec, Quantity::notch_width) ? "in the notch" : "at x = 0";
  Figure figure;
  figure.id = "map";
  figure.x = figure_axis(units.f_label, map.f());
  figure.y = figure_axis(units.delta_label, map.delta(), units.length.factor);
  figure.map = drawn(map, counts, v0 == 0, place);
  for (const ShadedClass& by : shaded) {
    shade_peaks(figure.map, map, by, units);
  }
  const bool any_rest = any_rests(counts, 0) || any_rests(counts, SweepClass::ranges);
  const bool any_peaks = figure.map.palette.size() > SweepClass::count;
  figure.title = format("How the motions end{}", any_rest && any_peaks ? ""
                                                 : any_rest  ? ", after how many half-cycles"
                                                 : any_peaks ? ", and their peaks"
                                                             : "");
  figure.description = format(
      "The plane of f and Δ. Centred means a rest {}, off centre one in the dead zone.", place);
  for (std::size_t i = 0; i < SweepClass::count; ++i) {
    if (counts.at(i) > 0) {
      figure.description += format(
          " {}: {:.3g} %.", figure.map.palette[i].name,
          100.0 * static_cast<double>(counts.at(i)) / static_cast<double>(map.cells().size()));
    }
  }
  figure.clauses = clauses(counts, place);
  if (any_peaks) {
    figure.clauses.emplace_back(
        "the values are peaks, the darker, the smaller where the motions end alike");
  }
  const double p = only_value(spec, Quantity::p);
  if (spec.kind == SweepKind::free && from_zero(spec) && plain_surface(spec) && v0 > 0 && p > 0) {
    add_boundaries(figure, {.v0 = v0, .p = p, .beta = v0 / p}, units,
                   {map.f().value(map.f().cells() - 1),
                    map.delta().value(map.delta().cells() - 1) * units.length});
    if (std::ranges::any_of(figure.curves, [](const figures::FigureCurve& curve) {
          return curve.name.find("Δ₁") != std::string::npos;
        })) {
      figure.clauses.emplace_back(
          "above the line of Δ₁ it stops on the first return if it returns at all");
    }
  }
  return figure;
}

}  // namespace stillpoint::report
