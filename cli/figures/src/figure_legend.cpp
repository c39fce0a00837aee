// SPDX-License-Identifier: MIT
#include "figure_legend.hpp"

#include "figure_backdrop.hpp"
#include "figure_layout.hpp"
#include "figure_looks.hpp"

#include <algorithm>

namespace stillpoint::figures {

namespace {

constexpr double line_height = 20;

}  // namespace

void FigureLegend::add(const Figure& figure, const std::set<std::string>& named) {
  const auto enter_unless_named = [&](const std::string& name, const std::string& sample) {
    if (!named.contains(name)) {
      enter(name, sample);
    }
  };
  for (const MapKey& key : figure.map.key) {
    enter(key.name,
          fmt::format(R"(<path class="cell" fill="{}" d="M2-10h20v12h-20Z"/>{})", key.colour,
                      key.hatched ? R"(<path class="over" d="M2 2L14-10M10 2L22-10"/>)" : ""));
  }
  for (const FigureArea& area : figure.areas) {
    if (!area.in_legend) {
      continue;
    }
    enter_unless_named(
        area.name,
        area.look == AreaLook::hatched
            ? fmt::format(R"x(<path fill="url(#{0})" d="{1}"/><path class="hatch {2}" d="{1}"/>)x",
                          hatch_id(figure, area.name), "M2-10h20v12h-20Z", word(area.ink))
            : fmt::format(R"(<path class="{} {}" d="M2-10h20v12h-20Z"/>)",
                          area.look == AreaLook::box ? "box" : "area", word(area.ink)));
  }
  for (const FigureBand& band : figure.bands) {
    enter_unless_named(
        band.name, fmt::format(R"(<path class="band {}" d="M2-10h20v12h-20Z"/>)", word(band.ink)));
  }
  for (const FigureCurve& curve : figure.curves) {
    enter_unless_named(curve.name, fmt::format(R"(<path class="curve {}{}" d="M0-4h24"/>)",
                                               word(curve.ink), word(curve.dash)));
  }
  for (const FigureMarks& marks : figure.marks) {
    if (!marks.points.empty()) {
      enter_unless_named(marks.name, mark(marks, R"x( transform="translate(12 -4)")x"));
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
  const double wide = 30 + 12 + text_width(name);
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
    text += fmt::format(
        "<g transform=\"translate({:.1f} {:.1f})\">{}<text x=\"30\">{}</text></g>\n", x + entry.x,
        y + 14 + line_height * entry.line, entry.sample, escaped(entry.name));
  }
  return text;
}

}  // namespace stillpoint::figures
