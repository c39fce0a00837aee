// SPDX-License-Identifier: MIT
#include "figure_looks.hpp"
#include "figure_parts.hpp"

#include <fmt/compile.h>

namespace stillpoint::figures {

namespace {

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
