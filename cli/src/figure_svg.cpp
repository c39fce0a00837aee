// SPDX-License-Identifier: MIT
// Draws a Figure. Lengths are in pixels of a page 520 wide; the plot is an svg of its own, so that
// a page can zoom into it, and what keeps its size there (marks, notes) is a "pin".
#include "figure.hpp"
#include "figure_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace stillpoint::cli {

namespace {

using fmt::format;

constexpr double width = 520;
constexpr double left = 74;
constexpr double upper = 34;
constexpr double plot_width = width - left - 16;
constexpr double plot_height = 290;
constexpr double legend_line = 20;
constexpr double letter = 6.9;  // mean width

constexpr std::array<std::string_view, 6> inks{"blue", "orange", "green", "purple", "sky", "grey"};
constexpr std::array<std::string_view, 3> dashes{"", " dashed", " dotted"};
constexpr std::array<std::string_view, 5> shapes{
    "M-4 0A4 4 0 1 1 4 0A4 4 0 1 1-4 0Z", "M-3.6 0A3.6 3.6 0 1 1 3.6 0A3.6 3.6 0 1 1-3.6 0Z",
    "M0-5.4L4.6 0L0 5.4L-4.6 0Z", "M-3.5-3.5H3.5V3.5H-3.5Z", "M-4-4L4 4M4-4L-4 4"};

template <class Enum, std::size_t size>
std::string_view word(const std::array<std::string_view, size>& words, Enum one) {
  return words.at(static_cast<std::size_t>(one));
}

/// Of UTF-8.
double letters(std::string_view text) {
  return static_cast<double>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool is_outline(Shape shape) {
  return shape == Shape::ring || shape == Shape::cross;
}

/// Appends to one text what is drawn.
class Drawing {
 public:
  explicit Drawing(const Figure& figure) : figure_(figure) {}

  std::string operator()(Frame frame) {
    lay_out_legend();
    open(frame);
    axes();
    plot();
    legend();
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  struct Entry {
    std::string name;
    std::string sample;  ///< drawn about (12, -4), 24 wide
    double x;
    double y;
  };

  template <class... Args>
  void add(fmt::format_string<Args...> what, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), what, std::forward<Args>(args)...);
  }

  [[nodiscard]] double px(double x) const {
    return (x - figure_.x.least) / (figure_.x.most - figure_.x.least) * plot_width;
  }
  [[nodiscard]] double py(double y) const {
    return (figure_.y.most - y) / (figure_.y.most - figure_.y.least) * plot_height;
  }

  void open(Frame frame) {
    const double height = legend_top() + legend_line * static_cast<double>(legend_lines_) + 4;
    add("<svg {}class=\"figure\" viewBox=\"0 0 {} {}\" role=\"img\" "
        "aria-labelledby=\"{}-title {}-desc\" data-x=\"{} {}\" data-y=\"{} {}\" "
        "data-plot=\"{} {} {} {}\">\n",
        frame == Frame::alone
            ? format("xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" ", width,
                     height)
            : "",
        width, height, figure_.id, figure_.id, figure_.x.least, figure_.x.most, figure_.y.least,
        figure_.y.most, left, upper, plot_width, plot_height);
    add("<title id=\"{}-title\">{}</title>\n<desc id=\"{}-desc\">{}</desc>\n", figure_.id,
        escaped(figure_.title), figure_.id, escaped(figure_.description));
    if (frame == Frame::alone) {
      add("<style>{}</style>\n<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", figure_style(),
          width, height);
    }
    add("<text class=\"title\" x=\"{}\" y=\"20\">{}</text>\n", left, escaped(figure_.title));
  }

  void axes() {
    text_ += "<g class=\"ticks\">\n";
    for (const double tick : ticks(figure_.x)) {
      add("<path class=\"grid\" d=\"M{:.2f} {}v{}\"/><text x=\"{:.2f}\" y=\"{}\" "
          "text-anchor=\"middle\">{:.10g}</text>\n",
          left + px(tick), upper, plot_height, left + px(tick), upper + plot_height + 17, tick);
    }
    for (const double tick : ticks(figure_.y)) {
      add("<path class=\"grid\" d=\"M{} {:.2f}h{}\"/><text x=\"{}\" y=\"{:.2f}\" "
          "text-anchor=\"end\">{:.10g}</text>\n",
          left, upper + py(tick), plot_width, left - 6, upper + py(tick) + 4, tick);
    }
    text_ += "</g>\n";
    add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", left + plot_width / 2,
        upper + plot_height + 36, escaped(figure_.x.label));
    add("<text transform=\"translate(15 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        upper + plot_height / 2, escaped(figure_.y.label));
  }

  void plot() {
    add("<svg class=\"plot\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">\n",
        left, upper, plot_width, plot_height, plot_width, plot_height);
    if (!figure_.map.cells.empty()) {
      add("<image width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
          "href=\"data:image/png;base64,{}\"/>\n",
          plot_width, plot_height, map_base64(figure_.map));
    }
    for (const FigureBand& band : figure_.bands) {
      add("<path class=\"band {}\" d=\"M{:.2f} 0V{}H{:.2f}V0Z\"/>\n", word(inks, band.ink),
          px(band.from), plot_height, px(band.to));
    }
    for (const FigureArea& area : figure_.areas) {
      add("<path class=\"{} {}\" d=\"{}Z\"><title>{}</title></path>\n",
          area.filled ? "area" : "edge", word(inks, area.ink), path(area.outline),
          escaped(area.name));
    }
    for (const FigureCurve& curve : figure_.curves) {
      add("<path class=\"curve {}{}{}\" d=\"", word(inks, curve.ink), word(dashes, curve.dash),
          curve.hover ? " hover" : "");
      for (const auto& stroke : curve.strokes) {
        text_ += path(stroke);
      }
      add("\"{}/>\n", curve.hover ? format(" data-name=\"{}\"", escaped(curve.name)) : "");
    }
    for (const FigureMarks& marks : figure_.marks) {
      for (const FigurePoint& at : marks.points) {
        add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\" data-name=\"{}\" "
            "data-at=\"{} {}\"><path class=\"{} {}\" d=\"{}\"/></g>\n",
            px(at.x), py(at.y), escaped(marks.name), at.x, at.y,
            is_outline(marks.shape) ? "ring" : "disc", word(inks, marks.ink),
            word(shapes, marks.shape));
      }
    }
    for (const FigureNote& note : figure_.notes) {
      constexpr std::array<std::string_view, 3> anchors{"start", "middle", "end"};
      add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\"><text class=\"note\" "
          "text-anchor=\"{}\"{}>{}</text></g>\n",
          px(note.at.x), py(note.at.y), word(anchors, note.anchor),
          note.upright ? " transform=\"rotate(-90)\" dy=\"-5\"" : " dy=\"-5\"", escaped(note.text));
    }
    text_ += "</svg>\n";
    add("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, upper,
        plot_width, plot_height);
  }

  [[nodiscard]] std::string path(const std::vector<FigurePoint>& points) const {
    std::string d;
    for (const FigurePoint& at : points) {
      fmt::format_to(std::back_inserter(d), "{}{:.2f} {:.2f}", d.empty() ? 'M' : 'L', px(at.x),
                     py(at.y));
    }
    return d;
  }

  [[nodiscard]] static double legend_top() { return upper + plot_height + 46; }

  void enter(const std::string& name, std::string sample) {
    const bool known =
        std::ranges::any_of(entries_, [&name](const Entry& entry) { return entry.name == name; });
    if (name.empty() || known) {
      return;
    }
    const double wide = 30 + 14 + letter * letters(name);
    if (legend_x_ > 0 && legend_x_ + wide > width - 20) {
      legend_x_ = 0;
      ++legend_lines_;
    }
    entries_.push_back(
        {name, std::move(sample), legend_x_, legend_line * static_cast<double>(legend_lines_)});
    legend_x_ += wide;
  }

  void lay_out_legend() {
    for (std::size_t i = 0; i < figure_.map.names.size(); ++i) {
      enter(figure_.map.names[i],
            format("<path class=\"cell\" fill=\"{}\" d=\"M4-10h16v12h-16Z\"/>",
                   figure_.map.palette[i]));
    }
    for (const FigureArea& area : figure_.areas) {
      enter(area.name, format("<path class=\"{} {}\" d=\"M2-10h20v12h-20Z\"/>",
                              area.filled ? "area" : "edge", word(inks, area.ink)));
    }
    for (const FigureBand& band : figure_.bands) {
      enter(band.name,
            format("<path class=\"band {}\" d=\"M2-10h20v12h-20Z\"/>", word(inks, band.ink)));
    }
    for (const FigureCurve& curve : figure_.curves) {
      enter(curve.name, format("<path class=\"curve {}{}\" d=\"M0-4h24\"/>", word(inks, curve.ink),
                               word(dashes, curve.dash)));
    }
    for (const FigureMarks& marks : figure_.marks) {
      enter(marks.points.empty() ? "" : marks.name,
            format("<path class=\"{} {}\" transform=\"translate(12 -4)\" d=\"{}\"/>",
                   is_outline(marks.shape) ? "ring" : "disc", word(inks, marks.ink),
                   word(shapes, marks.shape)));
    }
    legend_lines_ += entries_.empty() ? 0 : 1;
  }

  void legend() {
    for (const Entry& entry : entries_) {
      add("<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"30\">{}</text></g>\n",
          20 + entry.x, legend_top() + 14 + entry.y, entry.sample, escaped(entry.name));
    }
  }

  const Figure& figure_;
  std::string text_;
  std::vector<Entry> entries_;
  double legend_x_{0};
  int legend_lines_{0};
};

}  // namespace

std::string svg(const Figure& figure, Frame frame) {
  return Drawing(figure)(frame);
}

std::string_view figure_style() noexcept {
  return R"(
.figure text{font:13px "DejaVu Sans",Arial,sans-serif;fill:#222}
.figure .title{font-weight:bold}
.figure .note{font-size:12px;paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}
.figure .paper{fill:#fff}
.figure .frame{fill:none;stroke:#777}
.figure .grid{fill:none;stroke:#e3e3e3}
.figure .curve,.figure .edge{fill:none;stroke:currentColor;stroke-width:1.8;vector-effect:non-scaling-stroke;stroke-linejoin:round}
.figure .dashed{stroke-dasharray:7 4}
.figure .dotted{stroke-dasharray:2 3}
.figure .area{fill:currentColor;fill-opacity:.3}
.figure .band{fill:currentColor;fill-opacity:.25}
.figure .disc{fill:currentColor;stroke:#fff;stroke-width:.8}
.figure .ring{fill:none;stroke:currentColor;stroke-width:1.8}
.figure .cell{stroke:#777}
.figure image{image-rendering:pixelated}
.figure .blue{color:#0072b2}.figure .orange{color:#c04a00}.figure .green{color:#00805c}
.figure .purple{color:#a0527f}.figure .sky{color:#3a96cc}.figure .grey{color:#666}
)";
}

std::string_view dark_figure_style() noexcept {
  return R"(
.figure text{fill:#ddd}
.figure .note{stroke:#14181d}
.figure .grid{stroke:#2c3239}
.figure .disc{stroke:#14181d}
.figure .blue{color:#56a8f0}.figure .orange{color:#ff8a3d}.figure .green{color:#2bc492}
.figure .purple{color:#e39ac4}.figure .sky{color:#8fd3f5}.figure .grey{color:#a8a8a8}
)";
}

std::vector<double> ticks(const FigureAxis& axis) {
  constexpr double wanted = 6;
  const double raw = (axis.most - axis.least) / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double digit = raw / decade;
  const double step = decade * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
  std::vector<double> values;
  const double first = std::ceil(axis.least / step);
  for (int i = 0; (first + i) * step <= axis.most && i < 20; ++i) {
    values.push_back((first + i) * step + 0.0);
  }
  return values;
}

FigureAxis axis_around(std::string label, double least, double most) {
  constexpr double margin = 0.06;
  const double span = most - least;
  const double room = span > 0 ? margin * span : std::max(std::abs(most), 1e-300);
  return {std::move(label), least - room, most + room};
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace stillpoint::cli
