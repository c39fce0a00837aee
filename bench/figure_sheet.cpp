// SPDX-License-Identifier: MIT
#include "figure_sheet.hpp"
#include "figure_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace stillpoint::figures {

std::string svg(const FigureSheet& sheet) {
  constexpr double heading = 34;
  const auto count = static_cast<int>(sheet.figures.size());
  const double wide = figure_width * sheet.columns;
  FigureLegend legend(wide - legend_left);
  double one_height = 0;
  std::vector<FigureDrawing> drawings;
  for (const Figure& figure : sheet.figures) {
    drawings.emplace_back(figure);
    drawings.back().enter(legend);
    one_height = std::max(one_height, drawings.back().height());
  }
  const double first_line = heading + legend.height() + 8;
  const int lines = (count + sheet.columns - 1) / sheet.columns;
  const double high = first_line + one_height * lines;
  std::string text = opening(sheet, size_alone(wide, high), wide, high);
  text += paper(wide, high);
  text += fmt::format("<text class=\"title\" x=\"{}\" y=\"24\">{}</text>\n", legend_left,
                      escaped(sheet.title));
  text += legend.drawn(legend_left, heading);
  for (int i = 0; i < count; ++i) {
    const FigureDrawing& drawing = drawings[static_cast<std::size_t>(i)];
    const int line = i / sheet.columns;
    const std::string place =
        fmt::format(R"(x="{}" y="{}" width="{}" height="{}" )", figure_width * (i % sheet.columns),
                    first_line + one_height * line, figure_width, one_height);
    text += drawing.opened(place, one_height) + drawing.drawn() + "</svg>\n";
  }
  return text + "</svg>\n";
}

}  // namespace stillpoint::figures
