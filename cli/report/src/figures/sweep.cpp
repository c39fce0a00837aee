// SPDX-License-Identifier: MIT
#include "figures/region_figures.hpp"

#include <stillpoint/report/sweep.hpp>

#include <array>
#include <tuple>

namespace stillpoint::report {

namespace {

using sweep::Axis;
using sweep::MapAxis;
using sweep::Quantity;
using sweep::SweepClass;
using sweep::SweepKind;

/// Of all classes: the rests at x = 0 and those off it, whose scales have the same lightness, the
/// fewer half-cycles the darker, then the others. What never starts lies beside one half-cycle,
/// which is dark; a mass that does not move was caught at the start of a hit, or the load never
/// moved it. Hatched off x = 0, and where it locks.
std::vector<MapShade> palette(bool from_rest) {
  constexpr std::size_t ranges = SweepClass::ranges;
  constexpr std::array<std::array<const char*, ranges>, 2> rests{
      {{"#0b4f8a", "#2f7fc1", "#6aaede", "#9ecae9", "#c6dff2", "#e6f1fa"},
       {"#8a3b00", "#c85a00", "#ef8a2b", "#f7b267", "#fbd3a4", "#fdebd5"}}};
  std::vector<MapShade> all;
  for (const bool off : {false, true}) {
    for (std::size_t range = 0; range < ranges; ++range) {
      const int first = SweepClass::first_half_cycles.at(range);
      const int next = range + 1 < ranges ? SweepClass::first_half_cycles.at(range + 1) : 0;
      const std::string count = next == 0          ? format("{} or more", first)
                                : first < next - 1 ? format("{}–{}", first, next - 1)
                                                   : format("{}", first);
      all.push_back({rests.at(off ? 1 : 0).at(range),
                     format("{} after {} half-cycle{}", off ? "off centre" : "centred", count,
                            range == 0 ? "" : "s"),
                     count, off ? Hatch::one_way : Hatch::none});
    }
  }
  for (const auto& [colour, name, hatch] :
       {std::tuple("#b8b8b8", from_rest ? "stays at x = 0" : "never starts", Hatch::none),
        {"#000000", "never stops", Hatch::none},
        {"#a779cc", "not known to have stopped", Hatch::none},
        {"#f0e020", "locked", Hatch::crossed},
        {"#009e73", "perhaps too many half-cycles", Hatch::none}}) {
    all.push_back({colour, name, name, hatch});
  }
  return all;
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

/// The key has two colours that no cell has, the shades of more than a few cells and every other
/// colour.
FigureMap drawn(const sweep::SweepMap& map, const sweep::ClassCounts& counts, bool from_rest,
                const std::string& place) {
  constexpr std::size_t rests = 2 * SweepClass::ranges;
  const auto few = static_cast<std::int64_t>(map.cells().size() / 50);
  FigureMap drawn{map.f().cells(), map.delta().cells(), map.cells(), palette(from_rest), {}};
  if (counts.centred()) {
    drawn.key.push_back({"#4c96cf", "stops " + place});
  }
  if (counts.off_centre()) {
    drawn.key.push_back({"#dc7515", "stops off centre", "", Hatch::one_way});
  }
  for (std::size_t i = 0; i < SweepClass::count; ++i) {
    const auto& [colour, name, label, hatch] = drawn.palette[i];
    if (counts.of.at(i) > (i < rests ? few : 0)) {
      const bool locked = i == SweepClass::locked;  // in the key even if a label says so
      drawn.key.push_back({colour, locked ? format("{} {}", name, place) : name, "", hatch});
    }
  }
  return drawn;
}

/// Shades a class by its peaks, if they differ; the key says from which to which.
void shade_peaks(FigureMap& drawn, const sweep::SweepMap& map, const ShadedClass& by,
                 const FigureUnits& units) {
  const std::vector<double> bounds = even_bounds(map.peaks_of(by.index), 2 * peak_shades);
  if (bounds.empty() || bounds.front() == bounds.back()) {
    return;
  }
  constexpr double nothing = 1e-6;
  const auto words = [&](double peak) {  // rounding beside the largest is 0
    return format("{:.3g}{}", peak < nothing * bounds.back() ? 0 : peak * units.length,
                  with_blank(units.length.name));
  };
  const std::size_t first = drawn.palette.size();
  const std::string name = drawn.palette[by.index].name;
  const Hatch hatch = drawn.palette[by.index].hatch;
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
      {shade_of(by.shades, 0), format("{}, peak from {}", name, words(bounds.front())), "", hatch});
  drawn.key.push_back({shade_of(by.shades, peak_shades - 1),
                       format("{}, peak to {}", name, words(bounds.back())), "", hatch});
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

/// What the key does not say.
std::vector<std::string> clauses(const sweep::ClassCounts& counts) {
  const bool rests = counts.centred() || counts.off_centre();
  const std::string locks =
      counts.of.at(SweepClass::locked) == 0
          ? ""
          : format(
                "{}here the hatching is crossed, the notch holds the mass while the load goes on",
                rests ? "w" : "W");
  return {rests           ? "The darker an area, the fewer half-cycles the mass takes to stop"
          : locks.empty() ? "No mass that moves comes to rest"
                          : "",
          locks};
}

}  // namespace

std::vector<Figure> drawings(const SweepReport& report) {
  if (!report.map) {
    return {};
  }
  const sweep::SweepSpec& spec = report.spec;
  const sweep::SweepMap& map = *report.map;
  // Rows are in metres, figures in millimetres.
  const FigureUnits units{.length = spec.units ? Unit{1e3, "mm"} : Unit()};
  const sweep::ClassCounts counts = map.counts();
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
  const bool any_rest = counts.centred() || counts.off_centre();
  const bool any_peaks = figure.map.palette.size() > SweepClass::count;
  figure.title = format("How the motions end{}", any_rest && any_peaks ? ""
                                                 : any_rest  ? ", after how many half-cycles"
                                                 : any_peaks ? ", and their peaks"
                                                             : "");
  figure.description = format(
      "The plane of f and Δ. Centred means a rest {}, off centre one in the dead zone.", place);
  for (std::size_t i = 0; i < SweepClass::count; ++i) {
    if (counts.of.at(i) > 0) {
      figure.description += format(
          " {}: {:.3g} %.", figure.map.palette[i].name,
          100.0 * static_cast<double>(counts.of.at(i)) / static_cast<double>(map.cells().size()));
    }
  }
  figure.clauses = clauses(counts);
  if (any_peaks) {
    figure.clauses.emplace_back(
        "the values are peaks, the darker, the smaller where the motions end alike");
  }
  const double p = only_value(spec, Quantity::p);
  if (spec.kind == SweepKind::free && from_zero(spec) && plain_motion(spec) && v0 > 0 && p > 0) {
    const FigurePoint last{map.f().value(map.f().cells() - 1),
                           map.delta().value(map.delta().cells() - 1) * units.length};
    if (add_boundaries(figure, {.v0 = v0, .p = p, .beta = v0 / p}, units, last)) {
      figure.clauses.emplace_back(
          "above the line of Δ₁ it stops on the first return if it returns at all");
    }
  }
  return {std::move(figure)};
}

}  // namespace stillpoint::report
