// SPDX-License-Identifier: MIT
// Draws figures. The plot is an svg of its own, so that a page can zoom into it, and so are its
// marks, which may reach over the frame. A "pin" (a mark or a word) keeps its size when zoomed.
#include "figure_svg.hpp"
#include "figure_looks.hpp"
#include "figure_parts.hpp"

#include "page_files.hpp"

namespace stillpoint::figures {

namespace {

std::string_view scale_name(const FigureAxis& axis) {
  return axis.scale == Scale::linear ? "linear" : "logarithmic";
}

void add_words(std::string& text, const PlacedName& name, std::string_view look) {
  if (!name.leader.empty()) {
    add(text, "<path class=\"leader\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n", name.leader[0].x,
        name.leader[0].y, name.leader[1].x, name.leader[1].y);
  }
  text += pin(name.centre) + ">";
  if (name.on_lines) {
    const double width = text_width(name.text);
    add(text, R"(<path class="paper" d="M{0:.1f}-8h{1:.1f}v15H{0:.1f}Z"/>)", -width / 2, width);
  }
  add(text, "<text class=\"{}\" text-anchor=\"middle\" dy=\"4.5\"{}>{}</text></g>\n", look,
      name.upright ? " transform=\"rotate(-90)\"" : "", escaped(name.text));
}

}  // namespace

FigureDrawing::FigureDrawing(const Figure& drawn, double left)
    : figure(drawn),
      layout(drawn, left),
      plot{drawn.x, drawn.y, layout.width, drawn.height},
      names(names_in_place(drawn, plot)) {}

std::string FigureDrawing::opened(std::string_view place, double high) const {
  const std::string data = fmt::format(
      R"( data-x="{} {}" data-y="{} {}" data-scales="{} {}" data-plot="{} {} {} {}")",
      figure.x.least, figure.x.most, figure.y.least, figure.y.most, scale_name(figure.x),
      scale_name(figure.y), layout.left, layout.upper, layout.width, figure.height);
  return opening(figure, place, figure_width, high, data);
}

std::string FigureDrawing::drawn() const {
  constexpr double bold = 1.15;  // times as wide
  const bool fits = bold * text_width(figure.title) < figure_width - layout.left;
  const std::string place = fmt::format(R"(x="{}" y="{}" width="{}" height="{}")", layout.left,
                                        layout.upper, layout.width, figure.height);
  const std::string view =
      fmt::format(R"({} viewBox="0 0 {} {}")", place, layout.width, figure.height);
  std::string text = fmt::format("<text class=\"title\" x=\"{}\" y=\"18\">{}</text>\n",
                                 layout.left * (fits ? 1 : 0.1), escaped(figure.title));
  text += axes(figure, layout) + hatches(figure);
  add(text, "<svg class=\"plot\" {}>\n{}{}", view, map(figure, layout), contents(figure, plot));
  for (const PlacedName& name : names.words) {
    add_words(text, name, figure.map.cells.empty() ? "note" : "note on-map");
  }
  add(text,
      "</svg>\n<rect class=\"frame\" {}/>\n<svg class=\"plot pins\" overflow=\"visible\" "
      "{}>\n{}</svg>\n",
      place, view, marks(figure, plot));
  if (names.inset) {
    add(text, "<g class=\"inset\" transform=\"translate({} {})\">\n{}</g>\n", layout.left,
        layout.upper, inset(figure, plot, *names.inset));
  }
  return text;
}

std::string_view figure_style() noexcept {
  return figure_css;
}

std::string_view dark_figure_style() noexcept {
  return figure_dark_css;
}

std::string paper(double wide, double high) {
  return fmt::format(
      "<style>{}@media screen and (prefers-color-scheme: dark){{\n{}}}</style>\n"
      "<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n",
      figure_style(), dark_figure_style(), wide, high);
}

std::string size_alone(double wide, double high) {
  return fmt::format(R"(xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" )", wide, high);
}

std::string svg(const Figure& figure, Frame frame, double left) {
  const FigureDrawing drawing(figure, left);
  FigureLegend legend(figure_width - legend_left);
  drawing.enter(legend);
  const double high = drawing.height() + legend.height() + 4;
  const bool alone = frame == Frame::alone;
  return drawing.opened(alone ? size_alone(figure_width, high) : "", high) +
         (alone ? paper(figure_width, high) : "") + drawing.drawn() +
         legend.drawn(legend_left, drawing.height()) + "</svg>\n";
}

}  // namespace stillpoint::figures
