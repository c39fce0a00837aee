// SPDX-License-Identifier: MIT
#include "figure_words.hpp"

#include <iterator>

namespace stillpoint::figures {

namespace {

/// The part of an area on which no other box lies, and of a band on which no later one does.
Raster free_part(const Ground& ground, const FigureArea& area) {
  Raster inside(ground.plane.width, ground.plane.height);
  inside.fill(ground.plane.pixels(area.outline));
  for (const FigureArea& other : ground.figure.areas) {
    if ((other.look == AreaLook::box && &other != &area) ||
        (other.look == AreaLook::band && area.look == AreaLook::band && &other > &area)) {
      const auto corners = ground.plane.pixels(other.outline);
      const auto [left, right] = std::ranges::minmax(corners, {}, &FigurePoint::x);
      const auto [top, bottom] = std::ranges::minmax(corners, {}, &FigurePoint::y);
      inside.set({left.x, top.y, right.x, bottom.y}, false);
    }
  }
  return inside;
}

/// The cells of the map with entries of its palette from the first to before the end.
Raster cells_of(const Ground& ground, std::size_t first, std::size_t end) {
  const FigureMap& map = ground.figure.map;
  const Plane& plane = ground.plane;
  const auto cell = [](double at, double length, std::int64_t count) {
    return static_cast<std::int64_t>(at / length * static_cast<double>(count));
  };
  Raster inside(plane.width, plane.height);
  inside.set_where([&](const FigurePoint& at) {
    const std::int64_t row = map.rows - 1 - cell(at.y, plane.height, map.rows);
    const auto entry = map.cells[static_cast<std::size_t>(row * map.columns +
                                                          cell(at.x, plane.width, map.columns))];
    return first <= entry && entry < end;
  });
  return inside;
}

}  // namespace

NamesInPlace names_in_place(const Figure& figure, const Plane& plane) {
  Ground ground(figure, plane);
  NamesInPlace found;
  if (figure.inset) {
    found.inset = place_inset(ground);
  }
  const auto put = [&](std::optional<PlacedName> place) {  // whether there is one
    if (place) {
      ground.taken.set(place->box());
      found.named.insert(place->text);
      found.words.push_back(std::move(*place));
    }
    return place.has_value();
  };
  for (const FigureMarks& marks : figure.marks) {
    for (const FigurePoint& at : marks.points) {
      if (!plane.holds(at)) {
        put(near(ground, marks.name, {at_frame(plane, at)}));
      }
    }
  }
  for (const FigureNote& note : figure.notes) {
    put(near(ground, note.text, {plane.pixel(note.at)}));
  }
  for (const FigureCurve& curve : figure.curves) {
    if (curve.labelled) {
      put(near(ground, curve.name, plane.pixels(joined(curve.strokes))));
    }
  }
  for (const FigureArea& area : figure.areas) {
    // Words from edge to edge of a box would hide that it is one.
    const double least = area.look == AreaLook::box ? 3 : 0;
    if (!area.name.empty() && (area.again || !found.named.contains(area.name))) {
      put(within(ground, area.name, free_part(ground, area), least));
    }
  }
  const std::vector<MapShade>& palette = figure.map.palette;
  for (std::size_t entry = 0, next = 0; entry < palette.size(); entry = next) {
    const std::string& text = palette[entry].label;
    while (next < palette.size() && palette[next].label == text) {
      ++next;
    }
    if (!text.empty() && put(within(ground, text, cells_of(ground, entry, next)))) {
      found.named.erase(text);  // its key is that of the names
      for (std::size_t i = entry; i < next; ++i) {
        found.named.insert(palette[i].name);
      }
    }
  }
  return found;
}

}  // namespace stillpoint::figures
