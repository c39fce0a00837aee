// SPDX-License-Identifier: MIT
#include "figure_layout.hpp"

#include <array>

namespace stillpoint::figures {

namespace {

constexpr double axis_name = 26;  // beside the plot
constexpr double right_margin = 14;

Ticks labelled(const FigureAxis& axis, int wanted) {
  Ticks made;
  if (!axis.label.empty()) {
    made.values = ticks(axis, wanted);
    made.labels = tick_labels(made.values);
  }
  return made;
}

double widest(const Ticks& ticks) {
  double most = 0;
  for (const std::string& label : ticks.labels) {
    most = std::max(most, text_width(label));
  }
  return most;
}

}  // namespace

double text_width(std::string_view text) {
  constexpr double margin = 2;
  constexpr double usual = 8.3;  // digits and most letters
  static constexpr std::array<std::pair<std::string_view, double>, 6> others{
      {{" ',./:;IJ\\ijl|", 4.5},
       {"!()-[]frt", 5.5},
       {"?FLcsz\"*_`", 7.2},
       {"ABCKRVXZ", 9},
       {"&DGHNOQU#+<=>M^w~", 11},
       {"%@Wm", 13}}};
  double width = margin;
  for (const char c : text) {
    const bool goes_on = (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // of UTF-8
    const auto* const group = std::ranges::find_if(
        others, [c](const auto& each) { return each.first.find(c) != std::string_view::npos; });
    width += goes_on ? 0 : group != others.end() ? group->second : usual;
  }
  return width;
}

FigurePoint Plane::pixel(const FigurePoint& at) const {
  constexpr double far = 1e4;
  return {std::clamp(x.position(at.x) * width, -far, far),
          std::clamp((1 - y.position(at.y)) * height, -far, far)};
}

Points Plane::pixels(const Points& points) const {
  Points made(points);
  std::ranges::transform(points, made.begin(), [this](const auto& at) { return pixel(at); });
  return made;
}

bool Plane::holds(const FigurePoint& at) const {
  return at.x >= x.least && at.x <= x.most && at.y >= y.least && at.y <= y.most;
}

double plot_left(const Figure& figure) {
  constexpr double fewest = 40;  // five digits
  const Ticks y = labelled(figure.y, 6);
  return axis_name + std::max(fewest, widest(y) + 6);
}

Layout::Layout(const Figure& figure, double at_least)
    : y(labelled(figure.y, figure.height < 200 ? 5 : 6)),
      left(std::max(at_least, plot_left(figure))),
      bottom(upper + figure.height),
      axis_words(figure.x.label.empty() ? 6 : 44) {
  for (const int wanted : {6, 4, 3, 2}) {
    x = labelled(figure.x, wanted);
    width = figure_width - left - std::max(right_margin, widest(x) / 2 + 1);
    constexpr double apart = 10;
    if (static_cast<double>(x.labels.size()) * (widest(x) + apart) < width) {
      break;
    }
  }
}

}  // namespace stillpoint::figures
