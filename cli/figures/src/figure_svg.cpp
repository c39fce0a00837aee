// SPDX-License-Identifier: MIT
// Draws figures. Lengths are in pixels of a figure 520 wide; the plot is an svg of its own, so that
// a page can zoom into it. A "pin" (a mark or a note) keeps its size when zoomed.
#include "figure_legend.hpp"
#include "figure_looks.hpp"
#include "figure_map.hpp"

#include <iterator>
#include <map>
#include <utility>

namespace stillpoint::figures {

namespace {

using fmt::format;

constexpr double width = 520;
constexpr double left = 74;
constexpr double upper = 34;
constexpr double plot_width = width - left - 16;
constexpr double plot_height = 290;
constexpr double plot_bottom = upper + plot_height;
constexpr double axis_names = 46;  // below the plot
constexpr double legend_left = 20;

std::string_view scale_name(const FigureAxis& axis) {
  return axis.scale == Scale::linear ? "linear" : "logarithmic";
}

/// Collects the drawing of a figure in one text, without its svg element.
class Drawing {
 public:
  explicit Drawing(const Figure& figure) : figure_(figure) {}

  std::string operator()() {
    add("<text class=\"title\" x=\"{}\" y=\"20\">{}</text>\n", left, escaped(figure_.title));
    axes();
    open_plot();
    map();
    areas();
    curves();
    marks();
    notes();
    text_ += "</svg>\n";
    add("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, upper,
        plot_width, plot_height);
    return std::move(text_);
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> what, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), what, std::forward<Args>(args)...);
  }

  [[nodiscard]] double px(double x) const { return figure_.x.position(x) * plot_width; }
  [[nodiscard]] double py(double y) const { return (1 - figure_.y.position(y)) * plot_height; }

  [[nodiscard]] std::string path(const std::vector<FigurePoint>& points) const {
    std::string d;
    for (const FigurePoint& at : points) {
      fmt::format_to(std::back_inserter(d), "{}{:.2f} {:.2f}", d.empty() ? 'M' : 'L', px(at.x),
                     py(at.y));
    }
    return d;
  }

  [[nodiscard]] std::string path(const std::vector<std::vector<FigurePoint>>& strokes) const {
    std::string d;
    for (const auto& stroke : strokes) {
      d += path(stroke);
    }
    return d;
  }

  void axes() {
    text_ += "<g class=\"ticks\">\n";
    for (const double tick : ticks(figure_.x)) {
      add("<path class=\"grid\" d=\"M{:.2f} {}v{}\"/><text x=\"{:.2f}\" y=\"{}\" "
          "text-anchor=\"middle\">{:.10g}</text>\n",
          left + px(tick), upper, plot_height, left + px(tick), plot_bottom + 17, tick);
    }
    for (const double tick : ticks(figure_.y)) {
      add("<path class=\"grid\" d=\"M{} {:.2f}h{}\"/><text x=\"{}\" y=\"{:.2f}\" "
          "text-anchor=\"end\">{:.10g}</text>\n",
          left, upper + py(tick), plot_width, left - 6, upper + py(tick) + 4, tick);
    }
    text_ += "</g>\n";
    add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", left + plot_width / 2,
        plot_bottom + 36, escaped(figure_.x.label));
    add("<text transform=\"translate(15 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        upper + plot_height / 2, escaped(figure_.y.label));
  }

  void open_plot() {
    add("<svg class=\"plot\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">\n",
        left, upper, plot_width, plot_height, plot_width, plot_height);
  }

  void map() {
    if (!figure_.map.cells.empty()) {
      add("<image width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" data-names=\"{}\" "
          "href=\"data:image/png;base64,{}\"/>\n",
          plot_width, plot_height, cell_names(), map_base64(figure_.map));
    }
  }

  /// "#rrggbb name|#rrggbb name", for the readout.
  [[nodiscard]] std::string cell_names() const {
    std::string names;
    for (std::size_t i = 0; i < figure_.map.names.size(); ++i) {
      names += format("{}{} {}", i == 0 ? "" : "|", figure_.map.palette[i],
                      escaped(figure_.map.names[i]));
    }
    return names;
  }

  void areas() {
    for (const FigureBand& band : figure_.bands) {
      add("<path class=\"band {}\" d=\"M{:.2f} 0V{}H{:.2f}V0Z\"/>\n", word(band.ink), px(band.from),
          plot_height, px(band.to));
    }
    for (const FigureArea& area : figure_.areas) {
      add("<path class=\"{} {}\" d=\"{}Z\"><title>{}</title></path>\n",
          area.filled ? "area" : "edge", word(area.ink), path(area.outline), escaped(area.name));
    }
  }

  void curves() {
    for (const FigureCurve& curve : figure_.curves) {
      if (!figure_.map.cells.empty()) {
        add("<path class=\"halo\" d=\"{}\"/>\n", path(curve.strokes));
      }
      add("<path class=\"curve {}{}{}\" d=\"{}\"{}/>\n", word(curve.ink), word(curve.dash),
          curve.hover ? " hover" : "", path(curve.strokes),
          curve.hover ? format(" data-name=\"{}\"", escaped(curve.name)) : "");
    }
  }

  void marks() {
    for (const FigureMarks& marks : figure_.marks) {
      for (const FigurePoint& at : marks.points) {
        add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\" data-name=\"{}\" "
            "data-at=\"{} {}\">{}</g>\n",
            px(at.x), py(at.y), escaped(marks.name), at.x, at.y, mark(marks, ""));
      }
    }
  }

  void notes() {
    for (const FigureNote& note : figure_.notes) {
      add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\"><text class=\"note\" "
          "text-anchor=\"{}\"{}>{}</text></g>\n",
          px(note.at.x), py(note.at.y), word(note.anchor),
          note.upright ? " transform=\"rotate(-90)\" dy=\"-5\"" : " dy=\"-5\"", escaped(note.text));
    }
  }

  const Figure& figure_;
  std::string text_;
};

/// Opens an svg element, with the title and description that a screen reader needs and the data
/// that the script of a page needs.
std::string opened(const Figure& figure, std::string_view place, double height) {
  return format(
      "<svg {}class=\"figure\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-labelledby=\"{}-title {}-desc\" data-x=\"{} {}\" data-y=\"{} {}\" "
      "data-scales=\"{} {}\" data-plot=\"{} {} {} {}\">\n"
      "<title id=\"{}-title\">{}</title>\n<desc id=\"{}-desc\">{}</desc>\n",
      place, width, height, figure.id, figure.id, figure.x.least, figure.x.most, figure.y.least,
      figure.y.most, scale_name(figure.x), scale_name(figure.y), left, upper, plot_width,
      plot_height, figure.id, escaped(figure.title), figure.id, escaped(figure.description));
}

std::string paper(std::string_view style, double wide, double high) {
  return format("<style>{}</style>\n<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", style,
                wide, high);
}

std::string size_alone(double wide, double high) {
  return format(R"(xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" )", wide, high);
}

}  // namespace

std::string svg(const Figure& figure, Frame frame) {
  FigureLegend legend(width - legend_left);
  legend.add(figure);
  const double height = plot_bottom + axis_names + legend.height() + 4;
  const bool alone = frame == Frame::alone;
  std::string text = opened(figure, alone ? size_alone(width, height) : "", height);
  if (alone) {
    text += paper(figure_style(), width, height);
  }
  text += Drawing(figure)();
  text += legend.drawn(legend_left, plot_bottom + axis_names);
  return text + "</svg>\n";
}

std::string svg(const FigureSheet& sheet) {
  constexpr double heading = 34;
  constexpr double one_height = plot_bottom + axis_names;
  const auto count = static_cast<int>(sheet.figures.size());
  const double wide = width * sheet.columns;
  FigureLegend legend(wide - legend_left);
  for (const Figure& figure : sheet.figures) {
    legend.add(figure);
  }
  const double first_line = heading + legend.height() + 8;
  const int lines = (count + sheet.columns - 1) / sheet.columns;
  const double high = first_line + one_height * lines;
  std::string text = format(
      "<svg {}class=\"figure\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "aria-labelledby=\"{}-title {}-desc\">\n"
      "<title id=\"{}-title\">{}</title>\n<desc id=\"{}-desc\">{}</desc>\n",
      size_alone(wide, high), wide, high, sheet.id, sheet.id, sheet.id, escaped(sheet.title),
      sheet.id, escaped(sheet.description));
  text += paper(
      format("{}@media (prefers-color-scheme:dark){{{}}}", figure_style(), dark_figure_style()),
      wide, high);
  text += format("<text class=\"title\" x=\"{}\" y=\"24\">{}</text>\n", legend_left,
                 escaped(sheet.title));
  text += legend.drawn(legend_left, heading);
  for (int i = 0; i < count; ++i) {
    const Figure& figure = sheet.figures[static_cast<std::size_t>(i)];
    const int line = i / sheet.columns;
    const std::string place =
        format(R"(x="{}" y="{}" width="{}" height="{}" )", width * (i % sheet.columns),
               first_line + one_height * line, width, one_height);
    text += opened(figure, place, one_height);
    text += Drawing(figure)() + "</svg>\n";
  }
  return text + "</svg>\n";
}

std::string escaped(std::string_view text) {
  static const std::map<char, std::string_view> entities{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string result;
  for (const char& c : text) {
    const auto found = entities.find(c);
    result += found == entities.end() ? std::string_view(&c, 1) : found->second;
  }
  return result;
}

}  // namespace stillpoint::figures
