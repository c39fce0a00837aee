// SPDX-License-Identifier: MIT

// Small multiples: a panel a scene, error across, time up, both logarithmic. A line joins the
// settings of a method that count right; settings with a wrong count are hollow, crossed and on no
// line. Colours are those of Okabe and Ito, which the colour-blind tell apart; marks differ too.

#include "reports.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>

namespace stillpoint::bench {

namespace {

using Text = fmt::memory_buffer;

template <class... Arguments>
void add(Text& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
}

constexpr double width = 860;
constexpr double top = 96;  // title and legend
constexpr double panel_width = 418;
constexpr double panel_height = 270;
constexpr double left_margin = 56;  // of a panel, for the labels of time
constexpr double upper_margin = 30;
constexpr double plot_width = panel_width - left_margin - 14;
constexpr double plot_height = panel_height - upper_margin - 46;
constexpr int columns = 2;

constexpr int least_error = -17;  // decades of the error axis
constexpr int largest_error = 2;

constexpr std::string_view style = R"(<style>
text { font-family: system-ui, 'Segoe UI', 'DejaVu Sans', sans-serif; font-size: 12px; fill: #333 }
.title { font-size: 17px; font-weight: 600 }
.scene { font-size: 13px; font-weight: 600 }
.tick { font-size: 11px; fill: #555 }
.paper { fill: #fff }
.frame { fill: none; stroke: #999 }
.grid { stroke: #e4e4e4 }
.line { fill: none; stroke-width: 1.8 }
.wrong { stroke-width: 1.3 }
.stillpoint { color: #c04a00 }
.dopri5 { color: #0072b2 }
.RK4 { color: #a66f00 }
.rk8pd { color: #00805c }
.CVODE { color: #a0527f }
.regularised { color: #555 }
@media (prefers-color-scheme: dark) {
text { fill: #ddd }
.tick { fill: #aaa }
.paper { fill: #0d1117 }
.frame { stroke: #777 }
.grid { stroke: #2a2f36 }
.stillpoint { color: #ff8a3d }
.dopri5 { color: #56b4e9 }
.RK4 { color: #f0b429 }
.rk8pd { color: #2bc492 }
.CVODE { color: #e39ac4 }
.regularised { color: #b0b0b0 }
}
</style>
)";

struct Point {
  double x;
  double y;
};

/// Where a panel puts errors and times.
struct Panel {
  double left;  // of the plot
  double upper;
  int least_time;  // decades of seconds
  int largest_time;

  [[nodiscard]] Point place(double error, double seconds) const {
    // What is below the spacing of doubles is luck.
    const double across = std::log10(std::clamp(error, 1e-16, 10.0));
    return {
        left + plot_width * (across - least_error) / (largest_error - least_error),
        upper + plot_height * (largest_time - std::log10(seconds)) / (largest_time - least_time)};
  }
};

Panel panel(const SceneRows& scene, std::size_t index) {
  double least = scene.kernel().time.median;
  double largest = least;
  for (const MethodRows& method : scene.methods) {
    for (const Row& row : method.rows) {
      least = std::min(least, row.time.median);
      largest = std::max(largest, row.time.median);
    }
  }
  const auto column = static_cast<double>(index % columns);
  const std::size_t above = index / columns;
  const auto line = static_cast<double>(above);
  return {14 + column * panel_width + left_margin, top + line * panel_height + upper_margin,
          static_cast<int>(std::floor(std::log10(least * 0.9))),
          static_cast<int>(std::ceil(std::log10(largest * 1.1)))};
}

/// The mark of a method, by its place in the list: its outline about (0, 0).
std::string_view outline(std::size_t method) {
  constexpr std::array<std::string_view, 6> outlines{
      "M-6 0L-1.8-1.8L0-6L1.8-1.8L6 0L1.8 1.8L0 6L-1.8 1.8Z",  // star
      "M-3.2 0A3.2 3.2 0 1 1 3.2 0A3.2 3.2 0 1 1-3.2 0Z",      // disc
      "M-3-3H3V3H-3Z",                                         // square
      "M0-3.8L3.7 2.8H-3.7Z",                                  // triangle
      "M0-4.2L3.6 0L0 4.2L-3.6 0Z",                            // diamond
      "M0 3.8L3.7-2.8H-3.7Z",                                  // triangle on its tip
  };
  return outlines[method % outlines.size()];
}

void mark(Text& svg, std::size_t method, Point at, bool right) {
  if (right) {
    add(svg, "<path transform='translate({:.1f} {:.1f})' fill='currentColor' d='{}'/>\n", at.x,
        at.y, outline(method));
  } else {
    add(svg,
        "<path class='wrong' transform='translate({:.1f} {:.1f})' fill='none' "
        "stroke='currentColor' d='{}M-4.5-4.5L4.5 4.5M4.5-4.5L-4.5 4.5'/>\n",
        at.x, at.y, outline(method));
  }
}

std::string time_label(int decade) {
  constexpr std::array<std::string_view, 4> units{"ns", "us", "ms", "s"};
  const int from_ns = decade + 9;
  return fmt::format("{} {}",
                     from_ns % 3 == 0   ? 1
                     : from_ns % 3 == 1 ? 10
                                        : 100,
                     units.at(static_cast<std::size_t>(from_ns / 3)));
}

void axes(Text& svg, const Panel& panel, bool names_errors) {
  for (int decade = panel.least_time; decade <= panel.largest_time; ++decade) {
    const Point at{panel.left, panel.place(1, std::pow(10.0, decade)).y};
    add(svg, "<path class='grid' d='M{:.1f} {:.1f}h{:.1f}'/>\n", at.x, at.y, plot_width);
    add(svg, "<text class='tick' x='{:.1f}' y='{:.1f}' text-anchor='end'>{}</text>\n", at.x - 6,
        at.y + 4, time_label(decade));
  }
  for (int decade = -16; decade <= 0; decade += 4) {
    const Point at = panel.place(std::pow(10.0, decade), 1);
    add(svg, "<path class='grid' d='M{:.1f} {:.1f}v{:.1f}'/>\n", at.x, panel.upper, plot_height);
    add(svg, "<text class='tick' x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", at.x,
        panel.upper + plot_height + 16, decade == 0 ? "1" : fmt::format("1e{}", decade));
  }
  add(svg, "<rect class='frame' x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}'/>\n",
      panel.left, panel.upper, plot_width, plot_height);
  if (names_errors) {
    add(svg, "<text x='{:.1f}' y='{:.1f}' text-anchor='middle'>largest error</text>\n",
        panel.left + plot_width / 2, panel.upper + plot_height + 34);
  }
}

void method_line(Text& svg, const Panel& panel, const MethodRows& rows, std::size_t index) {
  add(svg, "<g class='{0}'><title>{0}</title>\n", rows.method.name);
  std::string path;
  for (const Row& row : rows.rows) {
    if (row.verdict.counts_right) {
      const Point at = panel.place(row.verdict.largest(), row.time.median);
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x, at.y);
    }
  }
  if (path.find('L') != std::string::npos) {
    add(svg, "<path class='line' stroke='currentColor' d='{}'/>\n", path);
  }
  for (const Row& row : rows.rows) {
    mark(svg, index, panel.place(row.verdict.largest(), row.time.median), row.verdict.counts_right);
  }
  add(svg, "</g>\n");
}

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
