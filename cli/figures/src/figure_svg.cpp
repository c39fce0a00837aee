// SPDX-License-Identifier: MIT
// Draws figures. The plot is an svg of its own, so that a page can zoom into it, and so are its
// marks, which may reach over the frame. A "pin" (a mark or a word) keeps its size when zoomed.
#include "figure_svg.hpp"
#include "figure_looks.hpp"
#include "figure_parts.hpp"

#include "page_files.hpp"

#include <fmt/compile.h>

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

/// Path data of straight lines.
std::string path(const Plane& plot, const Points& points) {
  std::string d;
  for (const FigurePoint& point : points) {
    const auto [x, y] = plot.pixel(point);
    fmt::format_to(std::back_inserter(d), FMT_COMPILE("{}{:.2f} {:.2f}"), d.empty() ? 'M' : 'L', x,
                   y);
  }
  return d;
}

std::string_view look_of(const Figure& figure, const FigureArea& area) {
  if (area.look != AreaLook::hatched) {
    return of(look_words, area.look);
  }
  // Between the lines of its hatching a thin one would not be seen.
  const double thick = thickness(figure, area);
  return thinnest < thick && thick < hatch_spacing ? "hatched thin" : "hatched";
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

std::string contents(const Figure& figure, const Plane& plot) {
  std::string text;
  for (const auto& layer : {std::pair(AreaLook::band, AreaLook::band),
                            {AreaLook::filled, AreaLook::hatched},
                            {AreaLook::box, AreaLook::box}}) {
    for (const FigureArea& area : figure.areas) {
      if (area.look < layer.first || area.look > layer.second) {
        continue;
      }
      const bool hatched = area.look == AreaLook::hatched;
      add(text, "<path class=\"{} {}\"{} d=\"{}Z\"><title>{}</title></path>\n",
          look_of(figure, area), of(ink_words, area.ink),
          hatched ? fmt::format(" fill=\"url(#{})\"", hatch_id(figure, area.name)) : "",
          path(plot, area.outline), escaped(area.told.empty() ? area.name : area.told));
    }
  }
  for (const FigureCurve& curve : figure.curves) {
    std::string d;
    for (const auto& stroke : curve.strokes) {
      d += path(plot, stroke);
    }
    if (!figure.map.cells.empty()) {
      add(text, "<path class=\"halo\" d=\"{}\"/>\n", d);
    }
    add(text, "<path class=\"curve {}{}{}\" d=\"{}\"{}/>\n", of(ink_words, curve.ink),
        of(dash_words, curve.dash), curve.hover ? " hover" : "", d,
        curve.hover ? fmt::format(" data-name=\"{}\"", escaped(curve.name)) : "");
  }
  return text;
}

}  // namespace stillpoint::figures
