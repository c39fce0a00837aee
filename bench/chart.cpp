// SPDX-License-Identifier: MIT

// Small multiples: one figure per scene, error across, time up, both logarithmic, on the same axes.

#include "figure_sheet.hpp"
#include "reports.hpp"

#include <stillpoint/figures/figure.hpp>
#include <stillpoint/figures/html_page.hpp>
#include <stillpoint/records/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace stillpoint::bench {

namespace {

using figures::Figure;
using figures::FigureAxis;
using figures::FigureCurve;
using figures::FigureMarks;
using figures::FigurePoint;
using figures::FigureSheet;
using figures::HtmlPage;
using figures::Ink;
using figures::Scale;
using figures::Shape;

constexpr double microsecond = 1e-6;

/// The style of a method, by its place in the list; the kernel is the first.
constexpr std::array<std::pair<Shape, Ink>, 6> looks{{{Shape::star, Ink::orange},
                                                      {Shape::disc, Ink::blue},
                                                      {Shape::square, Ink::amber},
                                                      {Shape::triangle, Ink::green},
                                                      {Shape::diamond, Ink::purple},
                                                      {Shape::wedge, Ink::grey}}};

FigurePoint place(const Row& row) {
  // An error below the spacing of doubles is luck.
  return {std::clamp(row.verdict.largest(), 1e-16, 10.0), row.time.median / microsecond};
}

/// Of all scenes.
FigureAxis time_axis(const Comparison& comparison) {
  double least = place(comparison.scenes.front().kernel()).y;
  double most = least;
  for (const SceneRows& scene : comparison.scenes) {
    for (const MethodRows& method : scene.methods) {
      for (const Row& row : method.rows) {
        least = std::min(least, place(row).y);
        most = std::max(most, place(row).y);
      }
    }
  }
  const auto decade = [](double value) { return std::pow(10.0, value); };
  return {"time of one simulation, µs", decade(std::floor(std::log10(least * 0.9))),
          decade(std::ceil(std::log10(most * 1.1))), Scale::logarithmic};
}

/// Two digits, "1400" and not "1.4e+03".
std::string microseconds(const Row& row) {
  return fmt::format("{} µs", records::decimal(place(row).y, 2));
}

std::string description(const SceneRows& scene) {
  std::string text =
      fmt::format("{}: stillpoint takes {} with an error of {:.1g}", scene.scene.legend,
                  microseconds(scene.kernel()), scene.kernel().verdict.largest());
  if (const auto rival = best_rival(scene, 1e-8)) {
    text += fmt::format("; the best other at 1e-8 is {} with {}", rival->method->method.name,
                        microseconds(*rival->row));
  }
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + ".";
}

/// A line through the settings with right counts, named beside it.
void add_method(Figure& figure, const MethodRows& method, std::size_t index, FigureMarks& wrong) {
  const auto [shape, ink] = looks.at(index % looks.size());
  const std::string name = method.method.name;
  FigureCurve line{.name = name, .strokes = {{}}, .ink = ink, .labelled = true};
  FigureMarks marks{name, {}, shape, ink};
  for (const Row& row : method.rows) {
    (row.verdict.counts_right ? line.strokes.front() : wrong.points).push_back(place(row));
    marks.points.push_back(place(row));
  }
  figure.curves.push_back(std::move(line));
  figure.marks.push_back(std::move(marks));
}

Figure figure_of(const SceneRows& scene, const FigureAxis& time) {
  Figure figure;
  figure.id = scene.scene.name;
  figure.title = fmt::format("{}: {}", scene.scene.name, scene.scene.legend);
  figure.description = description(scene);
  figure.x = {"largest error", 1e-17, 100, Scale::logarithmic};
  figure.y = time;
  FigureMarks wrong{"a wrong count", {}, Shape::cross, Ink::grey};
  for (std::size_t i = 0; i < scene.methods.size(); ++i) {
    add_method(figure, scene.methods[i], i, wrong);
  }
  figure.marks.push_back(std::move(wrong));
  return figure;
}

FigureSheet sheet(const Comparison& comparison) {
  FigureSheet all{"performance",
                  "Time of one simulation against its error: lower and further left is better",
                  "For each scene, time against largest error, both logarithmic.",
                  {}};
  const FigureAxis time = time_axis(comparison);
  for (const SceneRows& scene : comparison.scenes) {
    all.figures.push_back(figure_of(scene, time));
    all.description += " " + all.figures.back().description;
  }
  return all;
}

}  // namespace

std::string chart(const Comparison& comparison) {
  return figures::svg(sheet(comparison));
}

std::string chart_page(const Comparison& comparison) {
  FigureSheet all = sheet(comparison);
  HtmlPage page;
  page.title = "Speed against error";
  const Machine& machine = comparison.machine;
  page.verdict =
      fmt::format("{}. {}, {}, {}.", all.title, machine.processor, machine.compiler, machine.date);
  page.footer = "./dev bench";
  page.figures = std::move(all.figures);
  return figures::html(page);
}

}  // namespace stillpoint::bench
