// SPDX-License-Identifier: MIT
// Draws figures. The plot is an svg of its own, so that a page can zoom into it, and so are its
// marks, which may reach over the frame. A "pin" (a mark or a word) keeps its size when zoomed.
#include "figure_svg.hpp"

#include "figure_backdrop.hpp"
#include "figure_looks.hpp"
#include "figure_paths.hpp"
#include "page_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>

namespace stillpoint::figures {

namespace {

std::string_view scale_name(const FigureAxis& axis) {
  return axis.scale == Scale::linear ? "linear" : "logarithmic";
}

/// Collects the drawing of a figure in one text, without its svg element.
class Drawing {
 public:
  Drawing(const Figure& figure, const Layout& layout, const NamesInPlace& names)
      : figure_(figure), layout_(layout), names_(names) {}

  std::string operator()() {
    constexpr double bold = 1.15;  // times as wide
    const double high = figure_.height;
    add("<text class=\"title\" x=\"{}\" y=\"18\">{}</text>\n",
        layout_.left * (bold * text_width(figure_.title) < figure_width - layout_.left ? 1 : 0.1),
        escaped(figure_.title));
    text_ += axes(figure_, layout_) + hatches(figure_);
    const std::string place = fmt::format(R"(x="{}" y="{}" width="{}" height="{}")", layout_.left,
                                          layout_.upper, layout_.width, high);
    const std::string view = fmt::format(R"(viewBox="0 0 {} {}")", layout_.width, high);
    add("<svg class=\"plot\" {} {}>\n", place, view);
    text_ += map(figure_, layout_);
    contents(plane());
    words();
    add("</svg>\n<rect class=\"frame\" {}/>\n", place);
    add("<svg class=\"plot pins\" overflow=\"visible\" {} {}>\n", place, view);
    marks();
    text_ += "</svg>\n";
    inset();
    return std::move(text_);
  }

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> what, Args&&... args) {
    fmt::format_to(std::back_inserter(text_), what, std::forward<Args>(args)...);
  }

  [[nodiscard]] Plane plane() const {
    return {figure_.x, figure_.y, layout_.width, figure_.height};
  }

  /// Everything without a size of its own.
  void contents(const Plane& plot) {
    for (const FigureBand& band : figure_.bands) {
      add("<path class=\"band {}\" d=\"M{:.2f} 0V{}H{:.2f}V0Z\"/>\n", word(band.ink),
          plot.pixel({band.from, figure_.y.least}).x, plot.height,
          plot.pixel({band.to, figure_.y.least}).x);
    }
    areas(plot, false);
    areas(plot, true);
    for (const FigureCurve& curve : figure_.curves) {
      std::string d;
      for (const auto& stroke : curve.strokes) {
        d += path(plot, stroke, curve.smooth);
      }
      if (!figure_.map.cells.empty()) {
        add("<path class=\"halo\" d=\"{}\"/>\n", d);
      }
      add("<path class=\"curve {}{}{}\" d=\"{}\"{}/>\n", word(curve.ink), word(curve.dash),
          curve.hover ? " hover" : "", d,
          curve.hover ? fmt::format(" data-name=\"{}\"", escaped(curve.name)) : "");
    }
  }

  void areas(const Plane& plot, bool boxes) {
    for (const FigureArea& area : figure_.areas) {
      if ((area.look == AreaLook::box) != boxes) {
        continue;
      }
      const bool hatched = area.look == AreaLook::hatched;
      // Between the lines of its hatching a thin one would not be seen.
      const double thick = hatched ? thickness(figure_, area) : 0;
      const bool thin = thinnest < thick && thick < hatch_spacing;
      add("<path class=\"{} {}\"{} d=\"{}Z\"><title>{}</title></path>\n",
          boxes     ? "box"
          : thin    ? "hatched thin"
          : hatched ? "hatched"
                    : "area",
          word(area.ink),
          hatched ? fmt::format(" fill=\"url(#{})\"", hatch_id(figure_, area.name)) : "",
          path(plot, area.outline), escaped(area.told.empty() ? area.name : area.told));
    }
  }

  void marks() {
    constexpr double apart = 24;  // pixels between arrows
    const Plane plot = plane();
    std::vector<FigurePoint> arrows;
    for (const FigureCurve& curve : figure_.curves) {
      for (const auto& stroke : curve.strokes) {
        for (const Heading& heading :
             curve.directed ? headings(plot, stroke) : std::vector<Heading>{}) {
          const auto& at = heading.at;
          if (is_marked(plot, at) || std::ranges::any_of(arrows, [&](const FigurePoint& other) {
                return std::hypot(other.x - at.x, other.y - at.y) < apart;
              })) {
            continue;
          }
          arrows.push_back(at);
          add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\"><path class=\"disc arrow "
              "{}\" "
              "transform=\"rotate({:.1f})\" d=\"M-5-4.5L5 0L-5 4.5Z\"/></g>\n",
              at.x, at.y, word(curve.ink), heading.angle);
        }
      }
    }
    for (const FigureMarks& marks : figure_.marks) {
      for (const FigurePoint& at : marks.points) {
        const auto [x, y] = at_frame(plot, at);
        add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\" ", x, y);
        if (plot.holds(at)) {
          add("data-name=\"{}\" data-at=\"{} {}\">{}</g>\n", escaped(marks.name), at.x, at.y,
              mark(marks, ""));
        } else {
          add("data-far=\"{}\"><path class=\"disc {}\" transform=\"rotate({:.1f})\" "
              "d=\"M-9-2H-1V-7L9 0L-1 7V2H-9Z\"/></g>\n",
              escaped(marks.name), word(marks.ink), outward(plot, at));
        }
      }
    }
  }

  /// Where an arrow would lie on a mark.
  [[nodiscard]] bool is_marked(const Plane& plot, const FigurePoint& pixel) const {
    constexpr double apart = 11;
    return std::ranges::any_of(figure_.marks, [&](const FigureMarks& marks) {
      return std::ranges::any_of(marks.points, [&](const FigurePoint& point) {
        const FigurePoint at = plot.pixel(point);
        return std::hypot(at.x - pixel.x, at.y - pixel.y) < apart;
      });
    });
  }

  /// Degrees from the right, clockwise, along the nearest way out of the plot.
  static double outward(const Plane& plot, const FigurePoint& at) {
    const int right = at.x > plot.x.most ? 1 : at.x < plot.x.least ? -1 : 0;
    const int down = at.y > plot.y.most ? -1 : at.y < plot.y.least ? 1 : 0;
    return right == 0 ? 90.0 * down : right > 0 ? 45.0 * down : 180 - 45.0 * down;
  }

  void words() {
    const std::string_view look = figure_.map.cells.empty() ? "note" : "note on-map";
    for (const auto& [text, centre, upright, leader, on_lines] : names_.words) {
      if (!leader.empty()) {
        add("<path class=\"leader\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n", leader[0].x,
            leader[0].y, leader[1].x, leader[1].y);
      }
      const double width = text_width(text);
      add("<g class=\"pin\" transform=\"translate({:.2f} {:.2f})\">{}<text class=\"{}\" "
          "text-anchor=\"middle\" dy=\"4.5\"{}>{}</text></g>\n",
          centre.x, centre.y,
          on_lines ? fmt::format(R"(<path class="paper" d="M{:.1f}-8h{:.1f}v15H{:.1f}Z"/>)",
                                 -width / 2, width, -width / 2)
                   : "",
          look, upright ? " transform=\"rotate(-90)\"" : "", escaped(text));
    }
  }

  void inset() {
    if (!names_.inset) {
      return;
    }
    const auto& [left, top, right, bottom] = *names_.inset;
    const auto& [x, y] = *figure_.inset;
    const Plane plot = plane();
    const Plane part{x, y, right - left, bottom - top};
    const auto within = [](double at, double most) { return std::clamp(at, 0.0, most); };
    const auto low = plot.pixel({x.least, y.least});
    const auto high = plot.pixel({x.most, y.most});
    const double x0 = within(low.x, plot.width);
    const double x1 = within(high.x, plot.width);
    const double y0 = within(high.y, plot.height);
    const double y1 = within(low.y, plot.height);
    const double nearest = (left + right) / 2 < (x0 + x1) / 2 ? right : left;
    add("<g class=\"inset\" transform=\"translate({} {})\">\n<path class=\"lens\" "
        "d=\"M{:.2f} {:.2f}H{:.2f}V{:.2f}H{:.2f}ZM{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n",
        layout_.left, layout_.upper, x0, y0, x1, y1, x0, within((low.x + high.x) / 2, plot.width),
        within((low.y + high.y) / 2, plot.height), nearest, (top + bottom) / 2);
    add("<svg x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\">\n<rect class=\"paper\" "
        "width=\"100%\" height=\"100%\"/>\n",
        left, top, part.width, part.height);
    contents(part);
    for (const FigureMarks& marks : figure_.marks) {
      for (const FigurePoint& at : marks.points) {
        if (part.holds(at)) {
          const auto [px, py] = part.pixel(at);
          text_ += mark(marks, fmt::format(" transform=\"translate({:.2f} {:.2f})\"", px, py));
        }
      }
    }
    add("</svg>\n<rect class=\"frame\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
        "height=\"{:.2f}\"/></g>\n",
        left, top, part.width, part.height);
  }

  const Figure& figure_;
  const Layout& layout_;
  const NamesInPlace& names_;
  std::string text_;
};

}  // namespace

FigureDrawing::FigureDrawing(const Figure& figure, double left)
    : figure_(figure),
      layout_(figure, left),
      names_(names_in_place(figure, {figure.x, figure.y, layout_.width, figure.height})) {}

void FigureDrawing::enter(FigureLegend& legend) const {
  legend.add(figure_, names_.named);
}

double FigureDrawing::height() const {
  return layout_.bottom + layout_.axis_words;
}

std::string FigureDrawing::drawn() const {
  return Drawing(figure_, layout_, names_)();
}

std::string FigureDrawing::opened(std::string_view place, double height) const {
  const std::string data = fmt::format(
      R"( data-x="{} {}" data-y="{} {}" data-scales="{} {}" data-plot="{} {} {} {}")",
      figure_.x.least, figure_.x.most, figure_.y.least, figure_.y.most, scale_name(figure_.x),
      scale_name(figure_.y), layout_.left, layout_.upper, layout_.width, figure_.height);
  return opening(figure_, place, figure_width, height, data);
}

std::string_view figure_style() noexcept {
  return figure_css;
}

std::string_view dark_figure_style() noexcept {
  return figure_dark_css;
}

std::string paper(std::string_view style, double wide, double high) {
  return fmt::format("<style>{}</style>\n<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n",
                     style, wide, high);
}

std::string size_alone(double wide, double high) {
  return fmt::format(R"(xmlns="http://www.w3.org/2000/svg" width="{}" height="{}" )", wide, high);
}

std::string svg(const Figure& figure, Frame frame, double left) {
  const FigureDrawing drawing(figure, left);
  FigureLegend legend(figure_width - legend_left);
  drawing.enter(legend);
  const double height = drawing.height() + legend.height() + 4;
  const bool alone = frame == Frame::alone;
  std::string text = drawing.opened(alone ? size_alone(figure_width, height) : "", height);
  if (alone) {
    text += paper(figure_style(), figure_width, height);
  }
  text += drawing.drawn();
  text += legend.drawn(legend_left, drawing.height());
  return text + "</svg>\n";
}

namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t i = text.find(from); i != std::string::npos;
       i = text.find(from, i + to.size())) {
    text.replace(i, from.size(), to);
  }
}

constexpr std::string_view no_break = "\u00a0";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c | 32) >= 'a' && (c | 32) <= 'z';
}

/// "9.81 m/s2" in one piece.
void bind_units(std::string& text) {
  constexpr std::string_view micro = "\u00b5";
  for (std::size_t i = text.size(); i-- > 2;) {
    if (is_digit(text[i - 2]) && text[i - 1] == ' ' &&
        (text[i] == '%' || is_letter(text[i]) || text.compare(i, micro.size(), micro) == 0)) {
      text.replace(i - 1, 1, no_break);
    }
  }
}

/// "+-5 %", ">=" and "m/s2" as they are printed; "EN 15129", "f ≥ 0.02", "f + delta/w" and
/// "delta/(k - f)" in one piece.
void set_signs(std::string& text) {
  using Signs = std::pair<std::string_view, std::string_view>;
  constexpr auto signs = std::to_array<Signs>({{"+-", "\u00b1"},
                                               {"m/s2", "m/s\u00b2"},
                                               {"EN ", "EN\u00a0"},
                                               {"&gt;=", "\u2265"},
                                               {" \u2265 ", "\u00a0\u2265\u00a0"},
                                               {"&lt;=", "\u2264"},
                                               {" \u2264 ", "\u00a0\u2264\u00a0"},
                                               {" &gt; ", "\u00a0&gt;\u00a0"},
                                               {" &lt; ", "\u00a0&lt;\u00a0"},
                                               {" + ", "\u00a0+\u00a0"},
                                               {" - ", "\u00a0-\u00a0"}});
  for (const auto& [typed, printed] : signs) {
    replace_all(text, typed, printed);
  }
}

/// "f = 0.02" in one piece; of "0.03 = 5.9 mm" what follows the first number.
void bind_equations(std::string& text) {
  const auto begins_number = [&](std::size_t i) {
    return i < text.size() && (is_digit(text[i]) || text[i] == '-');
  };
  for (std::size_t i = text.rfind(" = "); i != std::string::npos && i > 0;
       i = text.rfind(" = ", i - 1)) {
    if (begins_number(i + 3)) {
      text.replace(i + 2, 1, no_break);
      const std::size_t word = text.rfind(' ', i - 1) + 1;  // npos + 1 is 0
      if (!begins_number(word)) {
        text.replace(i, 1, no_break);
      }
    }
  }
}

/// Browsers break "6.2e-09" and "1998-2" after the hyphen, and "--delta-max" too.
bool breaks_in_number(std::string_view word) {
  for (std::size_t i = 1; i + 1 < word.size(); ++i) {
    const bool exponent = i > 1 && word[i - 1] == 'e' && is_digit(word[i - 2]);
    if (word[i] == '-' && is_digit(word[i + 1]) && (exponent || is_digit(word[i - 1]))) {
      return true;
    }
  }
  return false;
}

std::string with_whole_numbers(std::string_view text) {
  constexpr std::size_t longest = 40;  // of what fits a narrow screen
  std::string result;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    const bool whole = word.size() <= longest && (word.starts_with("--") || breaks_in_number(word));
    result += whole ? fmt::format(R"(<span class="number">{}</span>)", word) : std::string(word);
    if (end < text.size()) {
      result += ' ';
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return result;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result(text);
  using Entity = std::pair<std::string_view, std::string_view>;
  for (const auto& [sign, entity] :
       {Entity{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}}) {
    replace_all(result, sign, entity);
  }
  return result;
}

std::string prose(std::string_view text) {
  std::string result = escaped(text);
  bind_units(result);
  bind_equations(result);
  set_signs(result);
  return with_whole_numbers(result);
}

}  // namespace stillpoint::figures
