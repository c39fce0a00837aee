// SPDX-License-Identifier: MIT
#include "figure_names.hpp"

#include "figure_inset.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace stillpoint::figures {

namespace {

class Names {
 public:
  Names(const Figure& figure, const Plane& plane) : figure_(figure), ground_(figure, plane) {}

  NamesInPlace operator()() {
    if (figure_.inset) {
      found_.inset = place_inset(ground_);
    }
    for (const FigureMarks& marks : figure_.marks) {
      for (const FigurePoint& at : marks.points) {
        if (!ground_.plane.holds(at)) {
          put(near(ground_, marks.name, {at_frame(ground_.plane, at)}));
        }
      }
    }
    for (const FigureNote& note : figure_.notes) {
      put(near(ground_, note.text, {ground_.plane.pixel(note.at)}));
    }
    for (const FigureCurve& curve : figure_.curves) {
      std::vector<FigurePoint> along;
      for (const auto& stroke : curve.strokes) {
        std::ranges::move(ground_.pixels(stroke), std::back_inserter(along));
      }
      if (curve.labelled) {
        put(near(ground_, curve.name, along));
      }
    }
    for (const FigureArea& area : figure_.areas) {
      // Words from edge to edge of a box would hide that it is one.
      const double least = area.look == AreaLook::box ? 3 : 0;
      if (!area.name.empty() && (area.again || !found_.named.contains(area.name))) {
        put(within(ground_, area.name, free_part(area), least));
      }
    }
    map_labels();
    return std::move(found_);
  }

 private:
  /// Whether there is a place.
  bool put(std::optional<PlacedName> place) {
    if (place) {
      ground_.taken.set(place->box());
      found_.named.insert(place->text);
      found_.words.push_back(std::move(*place));
    }
    return place.has_value();
  }

  /// The part of an area on which no other box lies, and of a band on which no later one does.
  [[nodiscard]] Raster free_part(const FigureArea& area) const {
    Raster inside(ground_.plane.width, ground_.plane.height);
    inside.fill(ground_.pixels(area.outline));
    for (const FigureArea& other : figure_.areas) {
      if ((other.look == AreaLook::box && &other != &area) ||
          (other.look == AreaLook::band && area.look == AreaLook::band && &other > &area)) {
        const auto corners = ground_.pixels(other.outline);
        const auto [left, right] = std::ranges::minmax(corners, {}, &FigurePoint::x);
        const auto [top, bottom] = std::ranges::minmax(corners, {}, &FigurePoint::y);
        inside.set({left.x, top.y, right.x, bottom.y}, false);
      }
    }
    return inside;
  }

  /// The cells of the map for which are(index) is true.
  template <class Are>
  [[nodiscard]] Raster cells_that(const Are& are) const {
    const FigureMap& map = figure_.map;
    const Plane& plane = ground_.plane;
    Raster inside(plane.width, plane.height);
    inside.set_where([&](const FigurePoint& at) {
      const auto column =
          static_cast<std::int64_t>(at.x / plane.width * static_cast<double>(map.columns));
      const auto row =
          map.rows - 1 -
          static_cast<std::int64_t>(at.y / plane.height * static_cast<double>(map.rows));
      return are(static_cast<std::size_t>(row * map.columns + column));
    });
    return inside;
  }

  void map_labels() {
    const FigureMap& map = figure_.map;
    for (std::size_t entry = 0, next = 0; entry < map.palette.size(); entry = next) {
      const std::string& text = map.palette[entry].label;
      while (next < map.palette.size() && map.palette[next].label == text) {
        ++next;
      }
      const auto is_labelled = [&](std::size_t cell) {
        return entry <= map.cells[cell] && map.cells[cell] < next;
      };
      if (!text.empty() && put(within(ground_, text, cells_that(is_labelled)))) {
        found_.named.erase(text);  // its key is that of the names
        for (std::size_t i = entry; i < next; ++i) {
          found_.named.insert(map.palette[i].name);
        }
      }
    }
  }

  const Figure& figure_;
  Ground ground_;
  NamesInPlace found_;
};

}  // namespace

NamesInPlace names_in_place(const Figure& figure, const Plane& plane) {
  return Names(figure, plane)();
}

}  // namespace stillpoint::figures
