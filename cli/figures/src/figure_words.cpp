// SPDX-License-Identifier: MIT
#include "figure_words.hpp"

#include <array>

namespace stillpoint::figures {

namespace {

/// Of words that cover nothing that they must not.
struct Place {
  FigurePoint at;
  bool upright;
  double cost;  ///< in cells of lines covered
};

constexpr std::array margins{40.0, 20.0, 10.0, 3.0};

/// The largest of them about a box within the set cells.
double margin_of(const Raster& inside, const Box& box) {
  const auto* const fits = std::ranges::find_if(
      margins, [&](double margin) { return inside.is_full(box.grown(margin)); });
  return fits == margins.end() ? 0 : *fits;
}

std::vector<Place> places(const Ground& ground, double width, const Raster& inside, double least) {
  constexpr double step = 4;              // pixels
  constexpr double clear = 2;             // pixels around it where a line would be close
  constexpr double tight = 0.1;           // of a cell covered, a pixel that a margin lacks
  constexpr double turned = 4.5;          // cells: rather upright than close to a line
  constexpr double loose = Raster::cell;  // a box is that much larger than its letters
  const Box all = inside.extent();
  const bool on_map = !ground.figure.map.cells.empty();  // whose numbers have no other place
  std::vector<Place> found;
  for (const bool upright : {false, true}) {
    if (upright && width < 2 * text_height) {
      continue;  // a single number is read level
    }
    const double w = upright ? text_height : width;
    const double h = upright ? width : text_height;
    for (double y = all.top + h / 2; y + h / 2 <= all.bottom; y += step) {
      for (double x = all.left + w / 2; x + w / 2 <= all.right; x += step) {
        const Box box = box_around({x, y}, w, h);
        if (inside.is_full(box) && ground.is_free(box) &&
            (on_map || ground.ink.set_in(box.grown(-loose)) == 0)) {
          const double margin = margin_of(inside, box);
          if (margin >= least) {
            found.push_back(
                {{x, y},
                 upright,
                 ground.ink.set_in(box.grown(clear)) - tight * margin + (upright ? turned : 0)});
          }
        }
      }
    }
  }
  return found;
}

}  // namespace

std::optional<PlacedName> within(const Ground& ground, const std::string& text,
                                 const Raster& inside, double least) {
  constexpr double alike = 1;     // cell
  constexpr double aside = 0.05;  // cells covered against pixels from the middle
  auto all = places(ground, text_width(text), inside, least);
  if (all.empty()) {
    return std::nullopt;
  }
  const Place best = *std::ranges::min_element(all, {}, &Place::cost);
  std::erase_if(all, [&](const Place& place) {
    return place.upright != best.upright || place.cost > best.cost + alike;
  });
  FigurePoint middle;
  for (const Place& place : all) {
    middle.x += place.at.x / static_cast<double>(all.size());
    middle.y += place.at.y / static_cast<double>(all.size());
  }
  const Place& chosen = *std::ranges::min_element(all, {}, [&](const Place& place) {
    return place.cost + aside * std::hypot(place.at.x - middle.x, place.at.y - middle.y);
  });
  return PlacedName{text, chosen.at, chosen.upright};
}

Ground::Ground(const Figure& drawn, const Plane& plot)
    : figure(drawn), plane(plot), ink(plot.width, plot.height), taken(plot.width, plot.height) {
  for (const FigureCurve& curve : figure.curves) {
    for (const auto& stroke : curve.strokes) {
      const auto line = plane.pixels(stroke);
      ink.set_line(line);
      if (curve.labelled || !curve.hover) {
        others.push_back(line);
        if (!figure.map.cells.empty()) {
          taken.set_line(line);
        }
      }
    }
  }
  for (const FigureArea& area : figure.areas) {
    if (area.look == AreaLook::filled || area.look == AreaLook::box) {  // others have no edge
      auto outline = plane.pixels(area.outline);
      outline.push_back(outline.front());
      ink.set_line(outline);
    }
  }
  constexpr double mark = 12;
  for (const FigureMarks& marks : figure.marks) {
    for (const FigurePoint& at : marks.points) {
      taken.set(box_around(at_frame(plane, at), mark, mark));
    }
  }
}

bool Ground::is_free(const Box& box) const {
  constexpr double edge = 2;  // pixels of the plot
  return box.left >= edge && box.top >= edge && box.right <= plane.width - edge &&
         box.bottom <= plane.height - edge && taken.set_in(box) == 0;
}

FigurePoint at_frame(const Plane& plane, const FigurePoint& at) {
  constexpr double apart = 10;
  const auto [x, y] = plane.pixel(at);
  return plane.holds(at) ? FigurePoint{x, y}
                         : FigurePoint{std::clamp(x, apart, plane.width - apart),
                                       std::clamp(y, apart, plane.height - apart)};
}

}  // namespace stillpoint::figures
