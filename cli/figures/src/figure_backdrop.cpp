// SPDX-License-Identifier: MIT
#include "figure_looks.hpp"
#include "figure_parts.hpp"

namespace stillpoint::figures {

namespace {

constexpr double label_gap = 6;  // between a label of y and the frame

/// The place of the first area of a name.
std::size_t first_of(const Figure& figure, const std::string& name) {
  const auto found = std::ranges::find(figure.areas, name, &FigureArea::name);
  return static_cast<std::size_t>(found - figure.areas.begin());
}

/// The lowest baseline of the labels of y: above the first label of x where that reaches below
/// them.
double lowest_baseline(const Layout& layout, const Plane& plot) {
  constexpr double below_frame = 4;
  constexpr double clear = 1;
  const bool reaches = !layout.x.values.empty() && plot.pixel({layout.x.values.front(), 0}).x -
                                                           text_width(layout.x.labels.front()) / 2 <
                                                       -label_gap;
  return layout.bottom + (reaches ? clear : below_frame);
}

/// "#rrggbb name|#rrggbb name", for the readout.
std::string cell_names(const FigureMap& map) {
  std::string names;
  for (const MapShade& shade : map.palette) {
    names += fmt::format("{}{} {}", names.empty() ? "" : "|", shade.colour, escaped(shade.name));
  }
  return names;
}

/// The path of the cells, each 1 wide and high, with at least that hatching.
std::string hatched_cells(const FigureMap& map, Hatch least) {
  const auto is_hatched = [&](std::int64_t row, std::int64_t column) {
    const auto cell = static_cast<std::size_t>(row * map.columns + column);
    return map.palette[map.cells[cell]].hatch >= least;
  };
  std::string text;
  for (std::int64_t row = 0; row < map.rows; ++row) {
    for (std::int64_t from = 0, to = 0; from < map.columns; from = to + 1) {
      for (to = from; to < map.columns && is_hatched(row, to);) {
        ++to;
      }
      if (from < to) {
        add(text, "M{} {}h{}v1H{}Z", from, map.rows - 1 - row, to - from, from);
      }
    }
  }
  return text;
}

}  // namespace

std::string axes(const Figure& figure, const Layout& layout) {
  std::string text;
  const Plane plot{figure.x, figure.y, layout.width, figure.height};
  text += "<g class=\"ticks\">\n";
  for (std::size_t i = 0; i < layout.x.values.size(); ++i) {
    const double x = layout.left + plot.pixel({layout.x.values[i], figure.y.least}).x;
    add(text,
        "<path class=\"grid\" d=\"M{:.2f} {}v{}\"/><text x=\"{:.2f}\" y=\"{}\" "
        "text-anchor=\"middle\">{}</text>\n",
        x, layout.upper, figure.height, x, layout.bottom + 17, layout.x.labels[i]);
  }
  const double lowest = lowest_baseline(layout, plot);
  for (std::size_t i = 0; i < layout.y.values.size(); ++i) {
    const double y = layout.upper + plot.pixel({figure.x.least, layout.y.values[i]}).y;
    add(text,
        "<path class=\"grid\" d=\"M{} {:.2f}h{}\"/><text x=\"{}\" y=\"{:.2f}\" "
        "text-anchor=\"end\">{}</text>\n",
        layout.left, y, layout.width, layout.left - label_gap, std::min(y + 4, lowest),
        layout.y.labels[i]);
  }
  text += "</g>\n";
  add(text, "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n",
      layout.left + layout.width / 2, layout.bottom + 35, escaped(figure.x.label));
  if (figure.y.label.empty()) {
    return text;
  }
  add(text, "<text transform=\"translate(14 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      layout.upper + figure.height / 2, escaped(figure.y.label));
  return text;
}

std::string hatches(const Figure& figure) {
  constexpr std::array angles{45, -45, 15, -15, 75, -75, 0, 90};  // each kind has its own
  std::string text;
  std::size_t kinds = 0;
  for (std::size_t i = 0; i < figure.areas.size(); ++i) {
    const FigureArea& area = figure.areas[i];
    if (area.look == AreaLook::hatched && first_of(figure, area.name) == i) {
      add(text,
          "<pattern id=\"{0}\" width=\"{1}\" height=\"{1}\" patternUnits=\"userSpaceOnUse\" "
          "patternTransform=\"rotate({2})\"><path class=\"hatch {3}\" d=\"M3.5 0V7\"/></pattern>\n",
          hatch_id(figure, area.name), hatch_spacing, angles.at(kinds++ % angles.size()),
          of(ink_words, area.ink));
    }
  }
  return text;
}

std::string hatch_id(const Figure& figure, const std::string& name) {
  return fmt::format("{}-hatch-{}", figure.id, first_of(figure, name));
}

std::string map(const Figure& figure, const Layout& layout) {
  std::string text;
  if (figure.map.cells.empty()) {
    return text;
  }
  const std::string& id = figure.id;
  const std::string size = fmt::format(R"(width="{}" height="{}")", layout.width, figure.height);
  add(text,
      "<image id=\"{}-map\" {} preserveAspectRatio=\"none\" data-names=\"{}\" "
      "href=\"data:image/png;base64,{}\"/>\n",
      id, size, cell_names(figure.map), map_base64(figure.map));
  for (const auto& [hatch, angle] : {std::pair(Hatch::one_way, 45), {Hatch::crossed, -45}}) {
    const std::string cells = hatched_cells(figure.map, hatch);
    if (cells.empty()) {
      continue;
    }
    add(text,
        "<clipPath id=\"{0}-{2}\"><path transform=\"scale({3} {4})\" d=\"{5}\"/></clipPath>\n"
        "<pattern id=\"{0}-{2}-over\" width=\"8\" height=\"8\" "
        "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate({6})\"><path class=\"over\" "
        "d=\"M4 0V8\"/><path class=\"over light\" d=\"M5 0V8\"/></pattern>\n<rect {1} "
        "fill=\"url(#{0}-{2}-over)\" clip-path=\"url(#{0}-{2})\"/>\n",
        id, size, hatch == Hatch::crossed ? "crossed" : "hatched",
        layout.width / static_cast<double>(figure.map.columns),
        figure.height / static_cast<double>(figure.map.rows), cells, angle);
  }
  return text;
}

}  // namespace stillpoint::figures
