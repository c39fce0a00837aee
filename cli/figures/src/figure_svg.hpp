// SPDX-License-Identifier: MIT
#pragma once

#include "figure_layout.hpp"
#include "figure_legend.hpp"
#include "figure_names.hpp"

#include <string>
#include <string_view>

namespace stillpoint::figures {

/// The layout of a figure. It refers to the figure.
class FigureDrawing {
 public:
  explicit FigureDrawing(const Figure& figure, double left = 0);

  /// Adds the names that have no place in the plot.
  void enter(FigureLegend& legend) const;
  /// Without a legend.
  [[nodiscard]] double height() const;
  /// Everything but the legend and the svg element around it.
  [[nodiscard]] std::string drawn() const;
  /// The beginning of an svg element: the title and description that a screen reader needs, and the
  /// data that the script of a page needs.
  [[nodiscard]] std::string opened(std::string_view place, double height) const;

 private:
  const Figure& figure_;
  Layout layout_;
  NamesInPlace names_;
};

/// A style, and the background.
[[nodiscard]] std::string paper(std::string_view style, double wide, double high);
[[nodiscard]] std::string size_alone(double wide, double high);

}  // namespace stillpoint::figures
