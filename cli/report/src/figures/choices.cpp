// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "figures/report_figures.hpp"

#include <array>
#include <iterator>

namespace stillpoint::report {

namespace {

/// One of the quantities over the stroke.
Figure over_stroke(Figure figure, const std::vector<Traded>& front, const Traded& chosen,
                   const FigureUnits& units, std::string name, Ink ink,
                   double (*quantity)(const Traded&)) {
  const auto place = [&](const Traded& now) {
    return FigurePoint{now.peak * units.length, quantity(now)};
  };
  Points all{place(chosen)};
  std::ranges::transform(front, std::back_inserter(all), place);
  const Points line(all.begin() + 1, all.end());
  const auto [shortest, longest] = std::ranges::minmax(line, {}, &FigurePoint::x);
  const auto [least, most] = std::ranges::minmax(all, {}, &FigurePoint::y);
  figure.height = 170;
  figure.x = axis_around(in("stroke", units.length), shortest.x, longest.x);
  figure.y = axis_around(name, least.y, most.y);
  figure.curves.push_back({std::move(name), {line}, ink});
  figure.marks.push_back({"design", {all.front()}, Shape::diamond, Ink::blue});
  return figure;
}

}  // namespace

void add_parts(Figure& figure, const Catalogue& catalogue, const FigureUnits& units) {
  std::array<figures::FigureMarks, 3> kinds{
      {{"parts that fail", {}, Shape::cross, Ink::purple},
       {"parts that tolerate too little", {}, Shape::triangle, Ink::amber, Fill::hollow},
       {"parts that fit", {}, Shape::disc, Ink::green, Fill::hollow}}};
  std::size_t outside = 0;
  for (const design::RatedPart& rated : catalogue.parts) {
    const FigurePoint at{rated.part.f, rated.part.delta * units.length};
    const auto within = [](double position) { return position >= 0 && position <= 1; };
    if (!within(figure.x.position(at.x)) || !within(figure.y.position(at.y))) {
      ++outside;
    } else {
      kinds.at(rated.admissible ? 2 : rated.tolerance ? 1 : 0).points.push_back(at);
    }
  }
  for (figures::FigureMarks& marks : kinds) {
    if (!marks.points.empty()) {
      figure.description += format(" {}: {}.", marks.name, marks.points.size());
      figure.marks.insert(figure.marks.begin(), std::move(marks));
    }
  }
  if (outside > 0) {
    figure.clauses.push_back(format("{} of the {} parts {} outside this figure", outside,
                                    catalogue.parts.size(), outside == 1 ? "lies" : "lie"));
  }
}

std::vector<Figure> trade_off_figures(const std::vector<Traded>& front, const Traded& chosen,
                                      const FigureUnits& units) {
  const bool of_hits = chosen.tolerance.has_value();
  Figure acceleration = over_stroke(
      {"trade-off", "Trade-off of stroke and acceleration",
       "The least transmitted acceleration for each stroke, and the design."},
      front, chosen, units, of_hits ? "acceleration outside the notch, g" : "acceleration, g",
      Ink::orange, [](const Traded& now) { return now.transmitted; });
  acceleration.y.label = "acceleration, g";  // the name is too long for its height
  if (!of_hits) {
    acceleration.clauses = {"Each point is the worst within the tolerance of its damper"};
    return {std::move(acceleration)};
  }
  Figure tolerance = over_stroke({"trade-off-tolerance", "Tolerance of the same dampers",
                                  "The largest tolerance for each stroke, and the design."},
                                 front, chosen, units, "tolerance, %", Ink::blue,
                                 [](const Traded& now) { return 100 * now.tolerance.value(); });
  tolerance.below = true;
  tolerance.clauses = {
      "Each point is the most tolerant damper of its stroke: none is better in one of the three "
      "without being worse in another",
      "inside a notch the acceleration is f + Δ/w + spring"};
  return {std::move(acceleration), std::move(tolerance)};
}

}  // namespace stillpoint::report
