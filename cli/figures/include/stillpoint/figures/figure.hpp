// SPDX-License-Identifier: MIT
#pragma once

// A figure as data. It is described once, here, and drawn once, by figure_svg.cpp.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stillpoint::figures {

struct FigurePoint {
  double x{0};
  double y{0};
};
using Points = std::vector<FigurePoint>;
using Strokes = std::vector<Points>;
/// The points of all of them.
[[nodiscard]] Points joined(const Strokes& strokes);

/// Colours of Okabe and Ito, which colour-blind readers can tell apart; data/page/figure.css has
/// their values.
enum class Ink { blue, orange, green, purple, sky, amber, grey };

enum class Dash { solid, dashed, dotted };

/// A line in one or several strokes.
struct FigureCurve {
  std::string name;  ///< in the legend; empty: not in it
  Strokes strokes;
  Ink ink{Ink::blue};
  Dash dash{Dash::solid};
  bool hover{true};      ///< shows its values under the pointer
  bool directed{false};  ///< arrows show its direction
  bool labelled{false};  ///< named beside its line
};

/// From the lower left corner on.
[[nodiscard]] inline Points rectangle(double left, double right, double bottom, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// A band is behind all areas; a box hides those below it and has an edge.
enum class AreaLook { band, filled, hatched, box };

/// A polygon. It is named inside if there is room, else in the legend if it can be seen.
struct FigureArea {
  std::string name;
  Points outline;
  Ink ink{Ink::blue};
  AreaLook look{AreaLook::filled};
  bool again{false};   ///< named if there is room, though another area has its name
  std::string told{};  ///< under the pointer; empty: its name
  std::string key{};   ///< in the legend, for all areas that have it; empty: its name
};

enum class Shape { disc, square, diamond, star, triangle, wedge, cross };

enum class Fill { solid, hollow };

/// A mark beyond the axes is an arrow at the frame, with its name.
struct FigureMarks {
  std::string name;
  Points points;
  Shape shape{Shape::disc};
  Ink ink{Ink::blue};
  Fill fill{Fill::solid};
};

/// Words in the plot, near a point.
struct FigureNote {
  std::string text;
  FigurePoint at;
};

/// Lines over the cells of a map, so that kinds differ on paper without colours too.
enum class Hatch { none, one_way, crossed };

/// An entry of the palette of a map, or of its legend.
struct MapShade {
  std::string colour;   ///< "#rrggbb"
  std::string name{};   ///< under the pointer, or in the legend
  std::string label{};  ///< in its largest areas; those that follow one another are one area
  Hatch hatch{Hatch::none};
};

/// The colours of a grid of cells that fills the axes; row 0 is the lowest. All cells have the same
/// size in the scales of the axes.
struct FigureMap {
  std::int64_t columns{0};
  std::int64_t rows{0};
  std::vector<std::uint8_t> cells;  ///< rows * columns entries of the palette
  std::vector<MapShade> palette;
  std::vector<MapShade> key;  ///< without those named as an area that is labelled
};

enum class Scale { linear, logarithmic };

struct FigureAxis {
  std::string label;  ///< with the unit
  double least{0};
  double most{1};
  Scale scale{Scale::linear};

  /// The place of a value: 0 at the least, 1 at the most; -1 for a value that has no logarithm, on
  /// a logarithmic axis.
  [[nodiscard]] double position(double value) const;
  /// The value at that place.
  [[nodiscard]] double value(double position) const;
};

/// Round values within the axis, about as many as wanted: 3 to 8 if 6 are wanted.
[[nodiscard]] std::vector<double> ticks(const FigureAxis& axis, int wanted = 6);
/// With as many digits as are needed to tell them apart, if more than that.
[[nodiscard]] std::vector<std::string> tick_labels(const std::vector<double>& ticks,
                                                   int fewest = 6);

/// An axis from the least to the largest value and slightly beyond; its length is never 0.
[[nodiscard]] FigureAxis axis_around(std::string label, double least, double most);

/// A part of the plane, enlarged in a corner.
struct FigureInset {
  FigureAxis x;
  FigureAxis y;
};

/// All values are finite, and both axes are longer than 0. An axis without a label has no ticks.
struct Figure {
  std::string id{};                    ///< of its file, "region" for instance
  std::string title{};                 ///< above it
  std::string description{};           ///< for readers who cannot see it
  std::vector<std::string> clauses{};  ///< of the sentence below it; empty ones do not count
  double height{270};                  ///< of the plot, in pixels of a figure 450 wide
  bool below{false};     ///< belongs below the previous figure, on the same horizontal axis
  std::string folded{};  ///< opens it, below the previous figure of a page; empty: always shown
  FigureAxis x{};
  FigureAxis y{};
  FigureMap map{};
  std::vector<FigureArea> areas{};
  std::vector<FigureCurve> curves{};
  std::vector<FigureMarks> marks{};
  std::vector<FigureNote> notes{};
  std::optional<FigureInset> inset{};

  /// The sentence: its clauses with semicolons between them, and a full stop.
  [[nodiscard]] std::string caption() const;
  /// A line that shows no values under the pointer.
  void add_line(std::string name, Strokes strokes, Ink ink, Dash dash = Dash::solid,
                bool labelled = false);
  /// Straight through the whole plot.
  [[nodiscard]] Points upright(double at) const;
  [[nodiscard]] Points level(double at) const;
  /// A span of x over the whole height.
  void add_band(std::string name, double from, double to, Ink ink, AreaLook look = AreaLook::band);
};

/// The width of an area in pixels, on average.
[[nodiscard]] double thickness(const Figure& figure, const FigureArea& area);
/// Whether that is enough to be seen; a box may be small, since it is enlarged.
[[nodiscard]] bool is_seen(const Figure& figure, const FigureArea& area);

/// The figure as SVG with its title, description and legend. Alone it is a file that is light or
/// dark as its reader's screen, otherwise it takes the colours of a page with figure_style(). The
/// plot begins at `left`, or farther right if its tick labels need the room.
enum class Frame { alone, in_page };
[[nodiscard]] std::string svg(const Figure& figure, Frame frame, double left = 0);
/// The least `left` of its plot.
[[nodiscard]] double plot_left(const Figure& figure);

/// The CSS of figures, in light colours, and the dark ones that a page adds.
[[nodiscard]] std::string_view figure_style() noexcept;
[[nodiscard]] std::string_view dark_figure_style() noexcept;

/// Text with the special characters of XML escaped.
[[nodiscard]] std::string escaped(std::string_view text);
/// The same for HTML, without line breaks between a number and its unit.
[[nodiscard]] std::string prose(std::string_view text);

}  // namespace stillpoint::figures
