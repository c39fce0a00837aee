// SPDX-License-Identifier: MIT
#include <stillpoint/figures/figure.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::figures {

namespace {

/// Multiples of 1, 2 or 5 times a power of ten.
std::vector<double> round_values(double least, double most, int wanted) {
  const double raw = (most - least) / wanted;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double digit = raw / decade;
  const double step = decade * (digit <= 1 ? 1 : digit <= 2 ? 2 : digit <= 5 ? 5 : 10);
  std::vector<double> values;
  const double first = std::ceil(least / step);
  for (int i = 0; (first + i) * step <= most && i < 20; ++i) {
    values.push_back((first + i) * step + 0.0);
  }
  return values;
}

/// Powers of ten: all of them, or every n-th.
std::vector<double> decades(double least, double most, int wanted) {
  const double first = std::ceil(least - 1e-9);
  const double last = std::floor(most + 1e-9);
  const double step = std::ceil((last - first + 1) / wanted);
  std::vector<double> values;
  for (double exponent = std::ceil(first / step) * step; exponent <= last; exponent += step) {
    values.push_back(std::pow(10.0, exponent));
  }
  return values;
}

/// How far a value is from the nearest number with so many digits.
double lost(double value, int digits) {
  if (value == 0) {
    return 0;
  }
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - (digits - 1));
  return std::abs(std::remainder(value, unit));
}

}  // namespace

Points joined(const Strokes& strokes) {
  Points all;
  for (const Points& stroke : strokes) {
    all.insert(all.end(), stroke.begin(), stroke.end());
  }
  return all;
}

double FigureAxis::position(double value) const {
  if (scale == Scale::linear) {
    return (value - least) / (most - least);
  }
  return value > 0 ? std::log10(value / least) / std::log10(most / least) : -1;
}

double FigureAxis::value(double position) const {
  return scale == Scale::linear ? least + (most - least) * position
                                : least * std::pow(most / least, position);
}

std::string Figure::caption() const {
  std::string text;
  for (const std::string& clause : clauses) {
    text += (text.empty() || clause.empty() ? "" : "; ") + clause;
  }
  return text.empty() ? text : text + '.';
}

void Figure::add_line(std::string name, Strokes strokes, Ink ink, Dash dash, bool labelled) {
  curves.push_back({std::move(name), std::move(strokes), ink, dash, false, false, labelled});
}

Points Figure::upright(double at) const {
  return {{at, y.least}, {at, y.most}};
}

Points Figure::level(double at) const {
  return {{x.least, at}, {x.most, at}};
}

void Figure::add_band(std::string name, double from, double to, Ink ink, AreaLook look) {
  areas.push_back({std::move(name), rectangle(from, to, y.least, y.most), ink, look});
}

std::vector<double> ticks(const FigureAxis& axis, int wanted) {
  if (axis.scale == Scale::logarithmic) {
    const double from = std::log10(axis.least);
    const double to = std::log10(axis.most);
    if (to - from >= 2) {
      return decades(from, to, wanted);
    }
  }
  return round_values(axis.least, axis.most, wanted);
}

std::vector<std::string> tick_labels(const std::vector<double>& ticks, int fewest) {
  constexpr double visible = 1e-3;  // of the distance between two ticks
  constexpr int every = 17;         // that a double has
  int digits = fewest;
  for (std::size_t i = 0; i < ticks.size() && ticks.size() > 1; ++i) {
    const double apart = std::abs(ticks[i] - ticks[i > 0 ? i - 1 : 1]);
    while (digits < every && lost(ticks[i], digits) > visible * apart) {
      ++digits;
    }
  }
  std::vector<std::string> labels;
  labels.reserve(ticks.size());
  for (const double tick : ticks) {
    labels.push_back(fmt::format("{:.{}g}", tick, digits));
  }
  return labels;
}

FigureAxis axis_around(std::string label, double least, double most) {
  constexpr double margin = 0.06;
  const double span = most - least;
  const double size = most != 0 ? std::max(std::abs(most), 1e-300) : 1;
  const double room = span > 0 ? margin * span : size;
  return {std::move(label), least - room, most + room};
}

}  // namespace stillpoint::figures
