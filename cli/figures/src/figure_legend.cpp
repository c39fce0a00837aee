// SPDX-License-Identifier: MIT
#include "figure_legend.hpp"
#include "figure_looks.hpp"
#include "figure_parts.hpp"

namespace stillpoint::figures {

namespace {

constexpr double line_height = 20;
constexpr std::string_view swatch = "M2-10h20v12h-20Z";

const std::string& key_of(const FigureArea& area) {
  return area.key.empty() ? area.name : area.key;
}

/// Areas of the same entry count together.
bool are_seen(const Figure& figure, const FigureArea& one) {
  double thick = 0;
  for (const FigureArea& area : figure.areas) {
    thick += key_of(area) == key_of(one) ? thickness(figure, area) : 0;
  }
  return one.look == AreaLook::box || thick > thinnest;
}

/// Whether the inset shows it.
bool is_enlarged(const Figure& figure, const FigureArea& area) {
  constexpr double thickest = 0.01;  // pixels, of an area that no inset shows
  const auto reaches = [&](const FigureAxis& axis, double FigurePoint::*along) {
    const auto ends = std::ranges::minmax(area.outline, {}, along);
    return ends.min.*along < axis.most && ends.max.*along > axis.least;
  };
  return figure.inset && thickness(figure, area) > thickest &&
         reaches(figure.inset->x, &FigurePoint::x) && reaches(figure.inset->y, &FigurePoint::y);
}

/// Over the sample of an entry.
std::string hatching(const MapShade& key) {
  return key.hatch == Hatch::none
             ? ""
             : fmt::format(
                   R"(<path class="over" d="M2 2L14-10M10 2L22-10{}"/><path class="over light" d="M3 2L15-10M11 2L22-9"/>)",
                   key.hatch == Hatch::crossed ? "M2-10L14 2M10-10L22 2" : "");
}

}  // namespace

double thickness(const Figure& figure, const FigureArea& area) {
  const Plane plane{figure.x, figure.y, figure_width, figure.height};
  double twice_area = 0;
  double perimeter = 0;
  const Points outline = plane.pixels(area.outline);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const FigurePoint& a = outline[i];
    const FigurePoint& b = outline[(i + 1) % outline.size()];
    twice_area += a.x * b.y - b.x * a.y;
    perimeter += std::hypot(b.x - a.x, b.y - a.y);
  }
  // 2 A/P is the width of a long strip.
  return perimeter > 0 ? std::abs(twice_area) / perimeter : 0;
}

bool is_seen(const Figure& figure, const FigureArea& area) {
  constexpr double least = 0.5;  // pixels
  return area.look == AreaLook::box || thickness(figure, area) > least;
}

void FigureLegend::add(const Figure& figure, const std::set<std::string>& named) {
  const auto enter = [&](const std::string& name, const std::string& sample) {
    const auto known = std::ranges::find(entries_, name, &Entry::name);
    if (name.empty() || named.contains(name)) {
      return;
    }
    if (known != entries_.end()) {
      known->sample += known->sample.find(sample) == std::string::npos ? sample : "";
      return;
    }
    const double wide = 30 + 12 + text_width(name);
    if (next_x_ > 0 && next_x_ + wide > width_) {
      next_x_ = 0;
      ++last_line_;
    }
    entries_.push_back({name, sample, next_x_, last_line_});
    next_x_ += wide;
  };
  for (const MapShade& key : figure.map.key) {
    enter(key.name, fmt::format(R"(<path class="cell" fill="{}" d="{}"/>{})", key.colour, swatch,
                                hatching(key)));
  }
  for (const FigureArea& area : figure.areas) {
    if (!named.contains(area.name) && (are_seen(figure, area) || is_enlarged(figure, area))) {
      const bool hatched = area.look == AreaLook::hatched;
      const std::string behind = hatched ? fmt::format("<path fill=\"url(#{})\" d=\"{}\"/>",
                                                       hatch_id(figure, area.name), swatch)
                                         : "";
      enter(key_of(area), fmt::format(R"({}<path class="{} {}" d="{}"/>)", behind,
                                      hatched ? "hatch" : of(look_words, area.look),
                                      of(ink_words, area.ink), swatch));
    }
  }
  for (const FigureCurve& curve : figure.curves) {
    if (!curve.strokes.empty()) {
      enter(curve.name, fmt::format(R"(<path class="curve {}{}" d="M0-4h24"/>)",
                                    of(ink_words, curve.ink), of(dash_words, curve.dash)));
    }
  }
  for (const FigureMarks& marks : figure.marks) {
    if (!marks.points.empty()) {
      enter(marks.name, mark(marks, R"x( transform="translate(12 -4)")x"));
    }
  }
}

double FigureLegend::height() const {
  return entries_.empty() ? 0 : line_height * (last_line_ + 1);
}

std::string FigureLegend::drawn(double x, double y) const {
  std::string text;
  for (const Entry& entry : entries_) {
    text += fmt::format(
        "<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"30\">{}</text></g>\n", x + entry.x,
        y + 14 + line_height * entry.line, entry.sample, escaped(entry.name));
  }
  return text;
}

}  // namespace stillpoint::figures
