// SPDX-License-Identifier: MIT
#include "chart_panel.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

namespace stillpoint::bench {

namespace {

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

std::string time_label(int decade) {
  constexpr std::array<std::string_view, 4> units{"ns", "us", "ms", "s"};
  const int from_ns = decade + 9;
  return fmt::format("{} {}",
                     from_ns % 3 == 0   ? 1
                     : from_ns % 3 == 1 ? 10
                                        : 100,
                     units.at(static_cast<std::size_t>(from_ns / 3)));
}

}  // namespace

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

}  // namespace stillpoint::bench
