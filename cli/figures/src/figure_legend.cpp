// SPDX-License-Identifier: MIT
#include "figure_legend.hpp"

#include "figure_looks.hpp"

#include <algorithm>

namespace stillpoint::figures {

namespace {

using fmt::format;

constexpr double line_height = 20;
constexpr double letter = 6.9;  // mean width

/// Of UTF-8.
double letters(std::string_view text) {
  return static_cast<double>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

void FigureLegend::add(const Figure& figure) {
  for (std::size_t i = 0; i < figure.map.names.size(); ++i) {
    enter(figure.map.names[i],
          format(R"(<path class="cell" fill="{}" d="M4-10h16v12h-16Z"/>)", figure.map.palette[i]));
  }
  for (const FigureArea& area : figure.areas) {
    enter(area.name, format(R"(<path class="{} {}" d="M2-10h20v12h-20Z"/>)",
                            area.filled ? "area" : "edge", word(area.ink)));
  }
  for (const FigureBand& band : figure.bands) {
    enter(band.name, format(R"(<path class="band {}" d="M2-10h20v12h-20Z"/>)", word(band.ink)));
  }
  for (const FigureCurve& curve : figure.curves) {
    enter(curve.name,
          format(R"(<path class="curve {}{}" d="M0-4h24"/>)", word(curve.ink), word(curve.dash)));
  }
  for (const FigureMarks& marks : figure.marks) {
    if (!marks.points.empty()) {
      enter(marks.name, mark(marks, R"x( transform="translate(12 -4)")x"));
    }
  }
}

void FigureLegend::enter(const std::string& name, const std::string& sample) {
  if (name.empty()) {
    return;
  }
  const auto known = std::ranges::find(entries_, name, &Entry::name);
  if (known != entries_.end()) {
    if (known->sample.find(sample) == std::string::npos) {
      known->sample += sample;
    }
    return;
  }
  const double wide = 30 + 14 + letter * letters(name);
  if (next_x_ > 0 && next_x_ + wide > width_) {
    next_x_ = 0;
    ++last_line_;
  }
  entries_.push_back({name, sample, next_x_, last_line_});
  next_x_ += wide;
}

double FigureLegend::height() const {
  return entries_.empty() ? 0 : line_height * (last_line_ + 1);
}

std::string FigureLegend::drawn(double x, double y) const {
  std::string text;
  for (const Entry& entry : entries_) {
    text +=
        format("<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"30\">{}</text></g>\n",
               x + entry.x, y + 14 + line_height * entry.line, entry.sample, escaped(entry.name));
  }
  return text;
}

}  // namespace stillpoint::figures
