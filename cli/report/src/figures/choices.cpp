// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace stillpoint::report {

using figures::Figure;
using figures::FigurePoint;
using figures::Fill;
using figures::Ink;
using figures::Shape;

namespace {

/// One of the quantities over the stroke.
Figure over_stroke(const std::vector<design::TradeOff>& front, const FigureUnits& units,
                   std::string name, double (*quantity)(const design::TradeOff&), Ink ink,
                   FigurePoint chosen) {
  Figure figure;
  figure.height = 170;
  figures::FigureCurve curve{std::move(name), {{}}, ink};
  double least = chosen.y;
  double most = chosen.y;
  for (const design::TradeOff& now : front) {
    curve.strokes[0].push_back({now.peak_amplitude * units.length, quantity(now)});
    least = std::min(least, quantity(now));
    most = std::max(most, quantity(now));
  }
  figure.x = figures::axis_around(in("stroke", units.length), curve.strokes[0].back().x,
                                  curve.strokes[0].front().x);
  figure.y = figures::axis_around(curve.name, least, most);
  figure.curves.push_back(std::move(curve));
  figure.marks.push_back({"design", {chosen}, Shape::diamond, Ink::blue});
  return figure;
}

}  // namespace

void add_parts(Figure& figure, const Catalogue& catalogue, const FigureUnits& units) {
  std::vector<FigurePoint> fit;
  std::vector<FigurePoint> too_little;
  std::vector<FigurePoint> fail;
  std::size_t outside = 0;
  for (const design::RatedPart& rated : catalogue.parts) {
    const FigurePoint at{rated.part.f, rated.part.delta * units.length};
    const auto within = [](double position) { return position >= 0 && position <= 1; };
    if (!within(figure.x.position(at.x)) || !within(figure.y.position(at.y))) {
      ++outside;
    } else {
      (rated.admissible ? fit : rated.tolerance ? too_little : fail).push_back(at);
    }
  }
  const auto add = [&figure](const char* name, std::vector<FigurePoint> points, Shape shape,
                             Ink ink, Fill fill) {
    if (!points.empty()) {
      figure.description += format(" {}: {}.", name, points.size());
      figure.marks.insert(figure.marks.begin(), {name, std::move(points), shape, ink, fill});
    }
  };
  add("parts that fail", std::move(fail), Shape::cross, Ink::purple, Fill::solid);
  add("parts that tolerate too little", std::move(too_little), Shape::triangle, Ink::amber,
      Fill::hollow);
  add("parts that fit", std::move(fit), Shape::disc, Ink::green, Fill::hollow);
  if (outside > 0) {
    figure.clauses.push_back(format("{} of the {} parts {} outside this figure", outside,
                                    catalogue.parts.size(), outside == 1 ? "lies" : "lie"));
  }
}

std::vector<Figure> trade_off_figures(const std::vector<design::TradeOff>& front,
                                      const design::Found& chosen, const FigureUnits& units) {
  const double stroke = chosen.response.peak_amplitude * units.length;
  Figure acceleration =
      over_stroke(front, units, "acceleration outside the notch, g",
                  [](const design::TradeOff& now) { return now.transmitted; }, Ink::orange,
                  {stroke, chosen.response.peak_absolute_acceleration});
  acceleration.id = "trade-off";
  acceleration.y.label = "acceleration, g";  // the name is too long for its height
  acceleration.title = "Trade-off of stroke, acceleration and tolerance";
  Figure tolerance =
      over_stroke(front, units, "tolerance, %",
                  [](const design::TradeOff& now) { return 100 * now.damper.tolerance; }, Ink::blue,
                  {stroke, 100 * chosen.point.tolerance});
  tolerance.id = "trade-off-tolerance";
  tolerance.title = "Tolerance of the same dampers";
  tolerance.below = true;
  tolerance.clauses = {
      "Each point is the most tolerant damper of its stroke: none is better in one of the three "
      "without being worse in another",
      "inside a notch the acceleration is f + Δ/w + spring"};
  acceleration.description = "The least transmitted acceleration for each stroke, and the design.";
  tolerance.description = "The largest tolerance for each stroke, and the design.";
  return {std::move(acceleration), std::move(tolerance)};
}

}  // namespace stillpoint::report
