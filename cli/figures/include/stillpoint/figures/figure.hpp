// SPDX-License-Identifier: MIT
#pragma once

// A figure as data. It is described once, here, and drawn once, by figure_svg.cpp.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stillpoint::figures {

struct FigurePoint {
  double x{0};
  double y{0};
};

/// Colours of Okabe and Ito, which the colour-blind tell apart; figure_style.cpp has their values.
enum class Ink { blue, orange, green, purple, sky, amber, grey };

enum class Dash { solid, dashed, dotted };

/// A line in one or several strokes.
struct FigureCurve {
  std::string name;  ///< in the legend; empty: not there
  std::vector<std::vector<FigurePoint>> strokes;
  Ink ink{Ink::blue};
  Dash dash{Dash::solid};
  bool hover{true};  ///< shows its values under the pointer
};

/// A filled polygon.
struct FigureArea {
  std::string name;
  std::vector<FigurePoint> outline;
  Ink ink{Ink::blue};
  bool filled{true};  ///< else its edge alone
};

/// A span of the horizontal axis, shaded.
struct FigureBand {
  std::string name;
  double from{0};
  double to{0};
  Ink ink{Ink::grey};
};

enum class Shape { disc, square, diamond, star, triangle, wedge, cross };

enum class Fill { solid, hollow, crossed };

struct FigureMarks {
  std::string name;
  std::vector<FigurePoint> points;
  Shape shape{Shape::disc};
  Ink ink{Ink::blue};
  Fill fill{Fill::solid};
};

enum class Anchor { start, middle, end };

/// A word in the plot, at a point; upright ones run along a vertical edge.
struct FigureNote {
  std::string text;
  FigurePoint at;
  Anchor anchor{Anchor::start};
  bool upright{false};
};

/// Colours of the cells of a grid, which fills the axes; row 0 is the lowest. All cells are as wide
/// as each other in the scale of the axis.
struct FigureMap {
  std::int64_t columns{0};
  std::int64_t rows{0};
  std::vector<std::uint8_t> cells;   ///< rows * columns entries of the palette
  std::vector<std::string> palette;  ///< "#rrggbb"
  std::vector<std::string>
      names;  ///< in the legend, for each entry of the palette; empty: not there
};

enum class Scale { linear, logarithmic };

struct FigureAxis {
  std::string label;  ///< with the unit
  double least{0};
  double most{1};
  Scale scale{Scale::linear};

  /// Where a value stands: 0 at the least, 1 at the most. What has no logarithm stands at -1 there.
  [[nodiscard]] double position(double value) const;
  /// The value that stands there.
  [[nodiscard]] double value(double position) const;
};

/// Some 3 to 8 round values within the axis.
[[nodiscard]] std::vector<double> ticks(const FigureAxis& axis);

/// From the least to the largest of the values and a little beyond; never empty.
[[nodiscard]] FigureAxis axis_around(std::string label, double least, double most);

/// All values finite, both axes longer than nothing.
struct Figure {
  std::string id;           ///< of its file, "region" for instance
  std::string title;        ///< above it
  std::string description;  ///< for those who cannot see it
  FigureAxis x;
  FigureAxis y;
  FigureMap map;
  std::vector<FigureBand> bands;
  std::vector<FigureArea> areas;
  std::vector<FigureCurve> curves;
  std::vector<FigureMarks> marks;
  std::vector<FigureNote> notes;
};

/// Several figures that share one legend.
struct FigureSheet {
  std::string id;
  std::string title;
  std::string description;
  std::vector<Figure> figures;
  int columns{2};
};

/// The figure as SVG with its own title, description and legend; nothing in it covers anything else
/// but notes, which have a rim. Alone it is a file of its own, in light colours; else it takes the
/// colours of the page that holds figure_style().
enum class Frame { alone, in_page };
[[nodiscard]] std::string svg(const Figure& figure, Frame frame);

/// A file of its own that follows the reader's choice of light or dark.
[[nodiscard]] std::string svg(const FigureSheet& sheet);

/// The CSS of figures, in light colours, and the dark ones that a page adds.
[[nodiscard]] std::string_view figure_style() noexcept;
[[nodiscard]] std::string_view dark_figure_style() noexcept;

/// Text fit for XML.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace stillpoint::figures
