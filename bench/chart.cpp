// SPDX-License-Identifier: MIT

// Small multiples: a panel a scene, error across, time up, both logarithmic.

#include "chart_panel.hpp"
#include "reports.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

namespace stillpoint::bench {

namespace {

void legend(Text& svg, const std::vector<MethodRows>& methods) {
  double x = 76;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    add(svg, "<g class='{}'>\n", methods[i].method.name);
    mark(svg, i, {x, 62}, true);
    add(svg, "</g>\n<text x='{:.1f}' y='66'>{}</text>\n", x + 11, methods[i].method.name);
    x += 32 + 7.0 * static_cast<double>(methods[i].method.name.size());
  }
  add(svg, "<g class='regularised'>\n");
  mark(svg, 1, {x, 62}, false);
  add(svg, "</g>\n<text x='{:.1f}' y='66'>crossed: a wrong count</text>\n", x + 12);
}

std::string description(const Comparison& comparison) {
  std::string text = "For each scene, time against largest error, both logarithmic.";
  for (const SceneRows& scene : comparison.scenes) {
    text += fmt::format(" {}: stillpoint {:.2g} microseconds at {:.1g}", scene.scene.name,
                        scene.kernel().time.median * 1e6, scene.kernel().verdict.largest());
    if (const auto rival = best_rival(scene, 1e-8)) {
      text += fmt::format(", the best other at 1e-8 is {} with {:.2g}", rival->method->method.name,
                          rival->row->time.median * 1e6);
    }
    text += '.';
  }
  return text;
}

}  // namespace

std::string chart(const Comparison& comparison) {
  const std::size_t count = comparison.scenes.size();
  const std::size_t panels_high = (count + columns - 1) / columns;
  const auto lines = static_cast<double>(panels_high);
  const double height = top + lines * panel_height + 6;
  Text svg;
  add(svg,
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' "
      "height='{1:.0f}' role='img' aria-labelledby='title description'>\n"
      "<title id='title'>Time against error of one simulation</title>\n"
      "<desc id='description'>{2}</desc>\n",
      width, height, description(comparison));
  add(svg, "{}<rect class='paper' width='{:.0f}' height='{:.0f}'/>\n", style, width, height);
  add(svg,
      "<text class='title' x='70' y='32'>Time of one simulation against its error</text>\n"
      "<text x='{:.0f}' y='32' text-anchor='end'>lower and further left is better</text>\n",
      width - 24);
  legend(svg, comparison.scenes.front().methods);
  for (std::size_t i = 0; i < count; ++i) {
    const SceneRows& scene = comparison.scenes[i];
    const Panel where = panel(scene, i);
    add(svg,
        "<text class='scene' x='{:.1f}' y='{:.1f}'>{}<tspan font-weight='400'>: {}</tspan>"
        "</text>\n",
        where.left, where.upper - 9, scene.scene.name, scene.scene.legend);
    axes(svg, where, i + columns >= count);
    for (std::size_t method = scene.methods.size(); method-- > 0;) {  // the kernel on top
      method_line(svg, where, scene.methods[method], method);
    }
  }
  add(svg, "</svg>\n");
  return fmt::to_string(svg);
}

}  // namespace stillpoint::bench
