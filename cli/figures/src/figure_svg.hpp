// SPDX-License-Identifier: MIT
#pragma once

#include "figure_legend.hpp"
#include "figure_words.hpp"

#include <fmt/format.h>

namespace stillpoint::figures {

/// A figure with its layout.
struct FigureDrawing {
  explicit FigureDrawing(const Figure& drawn, double left = 0);

  const Figure& figure;
  Layout layout;
  Plane plot;
  NamesInPlace names;

  /// Adds the names that have no place in the plot.
  void enter(FigureLegend& legend) const { legend.add(figure, names.named); }
  /// Without a legend.
  [[nodiscard]] double height() const { return layout.bottom + layout.axis_words; }
  /// The beginning of its svg element, with the data that the script of a page needs.
  [[nodiscard]] std::string opened(std::string_view place, double high) const;
  /// Everything but the legend and the svg element around it.
  [[nodiscard]] std::string drawn() const;
};

/// The beginning of the svg element of a figure or a sheet, with the title and the description that
/// a screen reader needs.
template <class Drawn>
[[nodiscard]] std::string opening(const Drawn& drawn, std::string_view place, double wide,
                                  double high, std::string_view data = {}) {
  return fmt::format(
      "<svg {1}class=\"figure\" viewBox=\"0 0 {2} {3}\" role=\"img\" "
      "aria-labelledby=\"{0}-title {0}-desc\"{4}>\n"
      "<title id=\"{0}-title\">{5}</title>\n<desc id=\"{0}-desc\">{6}</desc>\n",
      drawn.id, place, wide, high, data, escaped(drawn.title), escaped(drawn.description));
}

/// A style, and the background.
[[nodiscard]] std::string paper(double wide, double high);
[[nodiscard]] std::string size_alone(double wide, double high);

}  // namespace stillpoint::figures
