// SPDX-License-Identifier: MIT
#include "figure_names.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace stillpoint::figures {

namespace {

constexpr double step = 4;  // pixels between places that are tried
constexpr double edge = 2;  // pixels of the plot kept free of words

Box box_around(const FigurePoint& centre, double width, double height) {
  return {centre.x - width / 2, centre.y - height / 2, centre.x + width / 2, centre.y + height / 2};
}

FigurePoint nearest_of(const Box& box, const FigurePoint& at) {
  return {std::clamp(at.x, box.left, box.right), std::clamp(at.y, box.top, box.bottom)};
}

FigurePoint farthest_of(const Box& box, const FigurePoint& at) {
  return {at.x < (box.left + box.right) / 2 ? box.right : box.left,
          at.y < (box.top + box.bottom) / 2 ? box.bottom : box.top};
}

/// Whether the line through a and b separates two points.
bool is_between(const FigurePoint& a, const FigurePoint& b, const FigurePoint& one,
                const FigurePoint& other) {
  const auto side = [&](const FigurePoint& at) {
    return (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
  };
  return side(one) * side(other) < 0;
}

/// The place that covers the least of what is drawn, among places tried one after the other.
struct Best {
  double cost{std::numeric_limits<double>::infinity()};
  FigurePoint at{};

  void offer(double now, const FigurePoint& place) {
    if (now < cost) {
      cost = now;
      at = place;
    }
  }
  explicit operator bool() const { return std::isfinite(cost); }
};

class Places {
 public:
  Places(const Figure& figure, const Plane& plane)
      : figure_(figure),
        plane_(plane),
        ink_(plane.width, plane.height),
        taken_(plane.width, plane.height) {}

  NamesInPlace operator()() {
    draw();
    inset();
    for (const FigureNote& note : figure_.notes) {
      near(note.text, {plane_.pixel(note.at)});
    }
    for (const FigureArea& area : figure_.areas) {
      Raster inside(plane_.width, plane_.height);
      inside.fill(pixels(area.outline));
      // Words from edge to edge of a box would hide that it is one.
      const double least = area.look == AreaLook::box ? 3 : 0;
      if (area.again || !found_.named.contains(area.name)) {
        within(area.name, outside_boxes(area, inside), least);
      }
    }
    for (auto band = figure_.bands.begin(); band != figure_.bands.end(); ++band) {
      Raster inside(plane_.width, plane_.height);
      inside.set(strip(*band));
      for (auto above = std::next(band); above != figure_.bands.end(); ++above) {
        inside.clear(strip(*above));
      }
      if (!found_.named.contains(band->name)) {
        within(band->name, inside);
      }
    }
    map_labels();
    for (const FigureCurve& curve : figure_.curves) {
      if (curve.labelled) {
        std::vector<FigurePoint> along;
        for (const auto& stroke : curve.strokes) {
          const auto points = pixels(stroke);
          along.insert(along.end(), points.begin(), points.end());
        }
        near(curve.name, along);
      }
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::vector<FigurePoint> pixels(const std::vector<FigurePoint>& points) const {
    std::vector<FigurePoint> made;
    made.reserve(points.size());
    for (const FigurePoint& at : points) {
      made.push_back(plane_.pixel(at));
    }
    return made;
  }

  [[nodiscard]] Box strip(const FigureBand& band) const {
    return {plane_.pixel({band.from, 0}).x, 0, plane_.pixel({band.to, 0}).x, plane_.height};
  }

  /// The part of an area on which no box lies.
  [[nodiscard]] Raster outside_boxes(const FigureArea& area, Raster inside) const {
    for (const FigureArea& box : figure_.areas) {
      if (box.look == AreaLook::box && &box != &area) {
        const auto corners = pixels(box.outline);
        const auto [left, right] = std::ranges::minmax(corners, {}, &FigurePoint::x);
        const auto [top, bottom] = std::ranges::minmax(corners, {}, &FigurePoint::y);
        inside.clear({left.x, top.y, right.x, bottom.y});
      }
    }
    return inside;
  }

  /// What words should not cover, and what they must not: marks, and a box on a map.
  void draw() {
    for (const FigureCurve& curve : figure_.curves) {
      for (const auto& stroke : curve.strokes) {
        const auto line = pixels(stroke);
        ink_.set_line(line);
        if (curve.labelled) {
          limits_.push_back(line);
        } else if (!curve.hover) {
          others_.push_back(line);
          if (!figure_.map.cells.empty()) {
            taken_.set_line(line);
          }
        }
      }
    }
    for (const FigureArea& area : figure_.areas) {
      if (area.look != AreaLook::hatched) {  // which has no edge
        auto outline = pixels(area.outline);
        outline.push_back(outline.front());
        ink_.set_line(outline);
      }
    }
    for (const FigureBand& band : figure_.bands) {
      const Box stripe = strip(band);
      if (stripe.right - stripe.left < text_height) {
        ink_.set(stripe);
      }
    }
    for (const FigureMarks& marks : figure_.marks) {
      for (const FigurePoint& at : marks.points) {
        taken_.set(box_around(at_frame(plane_, at), 12, 12));
      }
      for (const FigurePoint& at : marks.points) {
        if (!plane_.holds(at)) {
          near(marks.name, {at_frame(plane_, at)});
        }
      }
    }
  }

  /// Where the least is drawn; the part that it enlarges stays visible.
  void inset() {
    if (!figure_.inset) {
      return;
    }
    constexpr double covering = 8;  // pixels farther away, a cell covered
    const double wide = 0.36 * plane_.width;
    const double high = 0.36 * plane_.height;
    const auto& [x, y] = *figure_.inset;
    const FigurePoint middle = plane_.pixel({(x.least + x.most) / 2, (y.least + y.most) / 2});
    Best best;
    for (const double cx : {plane_.width - wide / 2 - 8, wide / 2 + 8}) {
      for (const double cy : {high / 2 + 8, plane_.height - high / 2 - 8}) {
        const double apart = std::hypot(cx - middle.x, cy - middle.y);
        best.offer(covering * ink_.set_in(box_around({cx, cy}, wide, high)) - apart, {cx, cy});
      }
    }
    found_.inset = box_around(best.at, wide, high);
    taken_.set(*found_.inset);
    taken_.set(box_around(middle, 14, 14));
    const FigurePoint low = plane_.pixel({x.least, y.least});
    const FigurePoint high_end = plane_.pixel({x.most, y.most});
    ink_.set_line({low, {high_end.x, low.y}, high_end, {low.x, high_end.y}, low});
    ink_.set_line({middle, {best.at.x + (best.at.x < middle.x ? wide : -wide) / 2, best.at.y}});
  }

  [[nodiscard]] bool is_free(const Box& box) const {
    return box.left >= edge && box.top >= edge && box.right <= plane_.width - edge &&
           box.bottom <= plane_.height - edge && taken_.set_in(box) == 0;
  }

  void put(const std::string& text, const FigurePoint& centre, bool upright,
           std::vector<FigurePoint> leader = {}) {
    const double width = text_width(text);
    found_.words.push_back({text, centre, upright, std::move(leader)});
    found_.named.insert(text);
    taken_.set(upright ? box_around(centre, text_height, width)
                       : box_around(centre, width, text_height));
  }

  using Lines = std::vector<std::vector<FigurePoint>>;

  /// Whether a line lies between a point and a place of its words, however close to the point.
  [[nodiscard]] static bool is_beyond(const Lines& lines, const FigurePoint& point,
                                      const FigurePoint& nearest) {
    return std::ranges::any_of(lines, [&](const std::vector<FigurePoint>& line) {
      return std::ranges::adjacent_find(line, [&](const FigurePoint& a, const FigurePoint& b) {
               return is_between(a, b, point, nearest) && is_between(point, nearest, a, b);
             }) != line.end();
    });
  }

  /// Whether a leader would run through a mark that is not at its point.
  [[nodiscard]] bool is_marked(const FigurePoint& point, const FigurePoint& words) const {
    constexpr double own = 12;  // pixels
    const double length = std::hypot(words.x - point.x, words.y - point.y);
    for (double along = own; along < length; along += Raster::cell) {
      const FigurePoint at{std::lerp(point.x, words.x, along / length),
                           std::lerp(point.y, words.y, along / length)};
      if (taken_.set_in(box_around(at, 1, 1)) > 0) {
        return true;
      }
    }
    return false;
  }

  /// Beside, above or below one of the points: clear of every line, if that is not too far from it,
  /// and on its side of a limit, which words beyond it would call exceeded and words on it would
  /// name, or of another motion.
  void near(const std::string& text, const std::vector<FigurePoint>& points) {
    constexpr double clear = 2;        // pixels above and below
    constexpr double farther = 0.15;   // of a cell covered, a pixel
    constexpr double covering = 12;    // cells: 80 pixels away rather than on a line
    constexpr double misleading = 60;  // cells: rather on a line than on or beyond a limit
    constexpr double strange = 10;   // cells: rather beyond a motion to compare with than on a line
    constexpr double crossing = 30;  // cells: rather on a line than with a leader through a mark
    const double width = text_width(text);
    Best best;
    for (double gap = 7; gap < 70; gap += 4) {
      for (const FigurePoint& point : points) {
        for (const double right : {1.0, 0.0, -1.0, 0.5, -0.5, 0.25, -0.25}) {
          for (const double down : {-1, 1, 0}) {
            const FigurePoint centre{point.x + right * (width / 2 + gap),
                                     point.y + down * (text_height / 2 + gap)};
            const Box box = box_around(centre, width, text_height);
            if ((std::abs(right) == 1 || down != 0) && is_free(box)) {
              const int covered = ink_.set_in(box_around(centre, width, text_height + 2 * clear));
              best.offer(covered + (covered > 0 ? covering : 0) + farther * gap +
                             (is_beyond(limits_, point, farthest_of(box, point)) ? misleading : 0) +
                             (is_beyond(others_, point, nearest_of(box, point)) ? strange : 0) +
                             (is_marked(point, nearest_of(box, point)) ? crossing : 0),
                         centre);
            }
          }
        }
      }
    }
    if (best) {
      const Box box = box_around(best.at, width, text_height);
      put(text, best.at, false, leader(points, box));
      found_.words.back().on_lines = ink_.set_in(box) > 0;
    }
  }

  /// From words to the nearest of their points, unless they are close to it.
  [[nodiscard]] static std::vector<FigurePoint> leader(const std::vector<FigurePoint>& points,
                                                       const Box& words) {
    constexpr double close = 18;  // pixels: a mark lies between
    const auto apart = [&](const FigurePoint& point) {
      const FigurePoint nearest = nearest_of(words, point);
      return std::hypot(nearest.x - point.x, nearest.y - point.y);
    };
    const FigurePoint point = *std::ranges::min_element(points, {}, apart);
    return apart(point) > close ? std::vector{nearest_of(words, point), point}
                                : std::vector<FigurePoint>{};
  }

  /// Within the set cells, as far from their edge and from lines as may be, and at least so many
  /// pixels from their edge; false without room.
  bool within(const std::string& text, const Raster& inside, double least = 0) {
    constexpr double tight = 0.1;   // of a cell covered, a pixel that a margin lacks
    constexpr double turned = 4.5;  // cells: rather upright than close to a line
    if (text.empty()) {
      return true;
    }
    const double width = text_width(text);
    Best best;
    bool best_upright = false;
    for (const bool upright : {false, true}) {
      if (upright && width < 2 * text_height) {
        continue;  // a single number is read level
      }
      const double w = upright ? text_height : width;
      const double h = upright ? width : text_height;
      std::optional<std::vector<Place>> places;
      for (const double margin : {40.0, 20.0, 10.0, 3.0, 0.0}) {
        const auto cost_of = [&](double covered) {
          return covered - tight * margin + (upright ? turned : 0);
        };
        if (margin < least || best.cost <= cost_of(0)) {
          break;
        }
        if (!places) {
          places = free_places(inside, w, h);
        }
        const auto [covered, at] = fit(*places, inside, w, h, margin);
        const double cost = cost_of(covered);
        best_upright = cost < best.cost ? upright : best_upright;
        best.offer(cost, at);
      }
    }
    if (best) {
      put(text, best.at, best_upright);
    }
    return static_cast<bool>(best);
  }

  /// Of words that cover nothing that they must not.
  struct Place {
    FigurePoint at;
    int covered;       ///< cells of lines close to it
    bool fits{false};  ///< with the margin tried last
  };

  [[nodiscard]] std::vector<Place> free_places(const Raster& inside, double w, double h) const {
    constexpr double clear = 2;  // pixels around it where a line would be close
    using Range = Raster::Range;
    const Range all_rows = inside.rows(0, plane_.height);
    const Range all_columns = inside.columns(0, plane_.width);
    std::vector<std::pair<double, Range>> across;
    for (double x = w / 2; x < plane_.width; x += step) {
      if (x - w / 2 >= edge && x + w / 2 <= plane_.width - edge) {
        const Range columns = inside.columns(x - w / 2, x + w / 2);
        // Nothing is full that begins or ends beside all that is set.
        if (inside.set_in({columns.first, columns.first + 1}, all_rows) > 0 &&
            inside.set_in({columns.last - 1, columns.last}, all_rows) > 0) {
          across.emplace_back(x, columns);
        }
      }
    }
    std::vector<Place> places;
    for (double y = h / 2; y < plane_.height; y += step) {
      if (y - h / 2 >= edge && y + h / 2 <= plane_.height - edge) {
        const Range rows = inside.rows(y - h / 2, y + h / 2);
        if (inside.set_in(all_columns, {rows.first, rows.first + 1}) == 0 ||
            inside.set_in(all_columns, {rows.last - 1, rows.last}) == 0) {
          continue;
        }
        for (const auto& [x, columns] : across) {
          if (inside.is_full(columns, rows) && taken_.set_in(columns, rows) == 0 &&
              !is_on_line({x, y}, w, h)) {
            places.push_back(
                {{x, y}, ink_.set_in(box_around({x, y}, w + 2 * clear, h + 2 * clear))});
          }
        }
      }
    }
    return places;
  }

  /// Whether letters in the box would lie on a line. The number of cells in a map has no other
  /// place: its legend names only the colours.
  [[nodiscard]] bool is_on_line(const FigurePoint& at, double w, double h) const {
    constexpr double loose = Raster::cell;  // the box is that much larger than its letters
    return figure_.map.cells.empty() &&
           ink_.set_in(box_around(at, w - 2 * loose, h - 2 * loose)) > 0;
  }

  /// The middle of the places where a box with a margin fits and the least is close. What fits with
  /// a larger margin fits with this one.
  [[nodiscard]] static Best fit(std::vector<Place>& places, const Raster& inside, double w,
                                double h, double margin) {
    double count = 0;
    FigurePoint sum;
    for (auto& [at, covered, fits] : places) {
      fits = fits || inside.is_full(box_around(at, w + 2 * margin, h + 2 * margin));
      if (fits) {
        ++count;
        sum = {sum.x + at.x, sum.y + at.y};
      }
    }
    Best best;
    for (const auto& [at, covered, fits] : places) {
      constexpr double aside = 0.05;  // cells covered against pixels from the middle
      if (fits && covered < best.cost) {
        best.offer(covered + aside * std::hypot(at.x - sum.x / count, at.y - sum.y / count), at);
      }
    }
    return best;
  }

  /// The cells of the map for which are(index) is true.
  template <class Are>
  [[nodiscard]] Raster cells_that(const Are& are) const {
    const FigureMap& map = figure_.map;
    Raster inside(plane_.width, plane_.height);
    inside.set_where([&](const FigurePoint& at) {
      const auto column =
          static_cast<std::int64_t>(at.x / plane_.width * static_cast<double>(map.columns));
      const auto row =
          map.rows - 1 -
          static_cast<std::int64_t>(at.y / plane_.height * static_cast<double>(map.rows));
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
      if (!text.empty() && within(text, cells_that(is_labelled))) {
        found_.named.erase(text);  // its key is that of the names
        for (std::size_t i = entry; i < next; ++i) {
          found_.named.insert(map.palette[i].name);
        }
      }
    }
    for (const MapLabel& label : map.values) {
      within(label.text, cells_that([&label](std::size_t cell) {
               return std::binary_search(label.cells.begin(), label.cells.end(), cell);
             }));
    }
  }

  const Figure& figure_;
  const Plane& plane_;
  Raster ink_;
  Raster taken_;
  Lines limits_;  ///< lines that are named beside them
  Lines others_;  ///< motions to compare with, which words of a point beyond them would name
  NamesInPlace found_;
};

}  // namespace

NamesInPlace names_in_place(const Figure& figure, const Plane& plane) {
  return Places(figure, plane)();
}

FigurePoint at_frame(const Plane& plane, const FigurePoint& at) {
  constexpr double apart = 10;
  const auto [x, y] = plane.pixel(at);
  if (plane.holds(at)) {
    return {x, y};
  }
  return {std::clamp(x, apart, plane.width - apart), std::clamp(y, apart, plane.height - apart)};
}

}  // namespace stillpoint::figures
