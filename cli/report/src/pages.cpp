// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "damper.hpp"
#include "figures/motion_figures.hpp"
#include "figures/region_figures.hpp"
#include "format.hpp"
#include "sections.hpp"

#include <stillpoint/report/report.hpp>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;
using figures::HtmlPage;

namespace {

/// The design as its hit or its pulse moves it.
SimulationRequest moved(const DesignReport& report) {
  const design::Problem& problem = report.result.request.problem;
  const design::Found& found = *report.result.finding;
  SimulationRequest request;
  request.oscillator = {problem.p, found.point.f, found.point.delta};
  request.start = {0, problem.v0};
  if (found.pulse) {
    request.oscillator.p = found.pulse->p;
    request.start = {0, 0};
    request.excitation = design::excitation(found.pulse->pulse);
  }
  return request;
}

/// With the notch that will be built, beside the motion with the paper's where that can be seen.
DrawnMotion told(const DesignReport& report) {
  SimulationRequest request = moved(report);
  if (!report.built_notch) {
    return DrawnMotion(design::shown_motion(request));
  }
  design::ShownMotion ideal = design::shown_motion(request);
  const design::NotchShape& shape = report.built_notch->shape;
  request.oscillator.hold = shape.hold;
  request.surface.notch_width = shape.width;
  DrawnMotion motion(design::shown_motion(request));
  add_if_visible(motion, {.name = format("notch that {}", ideal_words(shown_damper(report))),
                          .states = std::move(ideal.states),
                          .ink = figures::Ink::purple,
                          .dash = figures::Dash::dashed});
  return motion;
}

/// The region of a task, with a damper and the parts to choose from in it.
Figure region_of(const ShownTask& task, const design::RegionVerdict& verdict,
                 const std::optional<DrawnDamper>& damper,
                 const std::optional<Catalogue>& catalogue) {
  const FigureUnits units = units_of(task.physical);
  const std::string mend =
      verdict.region.feasible ? "" : mend_title(verdict, task, catalogue ? "part" : "damper");
  DrawnRegion drawn{task.problem, task.limits, verdict.region, damper, mend};
  if (task.pulse) {
    drawn.pulse = design::pulse_problem(task.problem, *task.pulse, task.ranges);
    drawn.intervals = *verdict.intervals;
  }
  Figure figure = region_figure(drawn, units);
  if (catalogue) {
    add_parts(figure, *catalogue, units);
  }
  return figure;
}

/// The hits, or the pulses, that a damper works for.
Figure damper_figure(const ShownTask& task, double f, double delta,
                     const std::optional<design::WorksFor>& works_for) {
  return task.pulse
             ? strengths_figure(design::pulse_problem(task.problem, *task.pulse, task.ranges), f,
                                delta, works_for)
             : hits_figure(task.problem, task.limits, f, delta, works_for, units_of(task.physical));
}

/// Its trade-offs, and what it works for.
std::vector<Figure> damper_figures(const DesignReport& report, const FigureUnits& units) {
  const design::Found& found = *report.result.finding;
  std::vector<Figure> figures;
  if (report.trade_off && report.trade_off->size() > 1) {
    figures = trade_off_figures(*report.trade_off, found, units);
  }
  figures.push_back(
      damper_figure(task_of(report), found.point.f, found.point.delta, found.works_for));
  return figures;
}

/// What the design does after its hit, or under its pulse.
std::vector<Figure> told_figures(const DesignReport& report, const FigureUnits& units) {
  DrawnMotion motion = told(report);
  if (const std::string which = shown_motion(shown_damper(report)); !which.empty()) {
    motion.with = fmt::format("With {}, ", which);
  }
  motion.beta = report.result.request.problem.beta;
  Figure figure = motion_figure(motion, units);
  const auto& check = report.result.finding->pulse;
  if (!check) {
    return {std::move(figure), phase_figure(motion, units), energy_figure(motion, units)};
  }
  figure.id = "pulse";
  figure.title = "Motion under the pulse itself";
  std::vector<Figure> figures{std::move(figure),
                              excitation_figure(design::excitation(check->pulse), motion, units)};
  if (is_moving(motion)) {
    figures.push_back(phase_figure(motion, units));
  }
  return figures;
}

std::vector<Figure> drawings_of(const MotionReport& report, const DrawnMotion& motion) {
  const FigureUnits units = units_of(report.physical);
  std::vector<Figure> figures{motion_figure(motion, units)};
  if (is_forced(report.request)) {
    figures.push_back(excitation_figure(report.request.excitation, motion, units));
  }
  if (is_moving(motion)) {
    figures.push_back(phase_figure(motion, units));
  }
  if (!is_forced(report.request)) {
    figures.push_back(energy_figure(motion, units));
  }
  return figures;
}

/// Of a design with which notch the captions are.
void add_ideal(std::vector<Figure>& figures, const std::string& ideal) {
  for (Figure& figure : figures) {
    if (!figure.clauses.empty()) {
      figure.clauses.front() += ideal;
    }
  }
}

/// Of a mass that stands still, only a load that it withstands.
bool has_figures(const DrawnMotion& motion) {
  return motion.states.back().tau > 0;
}

}  // namespace

HtmlPage page(const DesignReport& report) {
  const FigureUnits units = units_of(report.physical);
  HtmlPage page = page_of(document(report, Verbosity::full));
  const auto& found = report.result.finding;
  std::optional<DrawnDamper> damper;
  if (found) {
    const auto& [f, delta, tolerance] = found->point;
    damper = DrawnDamper{"design", f, delta, tolerance};
  }
  page.figures = {region_of(task_of(report), report.result, damper, report.catalogue)};
  if (!found) {
    return page;
  }
  std::ranges::move(damper_figures(report, units), std::back_inserter(page.figures));
  add_ideal(page.figures, with_ideal(shown_damper(report)));
  std::ranges::move(told_figures(report, units), std::back_inserter(page.figures));
  return page;
}

std::vector<Figure> drawings(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  std::optional<DrawnDamper> point;
  if (answer.admissible) {
    point = {*answer.admissible ? "point, admissible" : "point, not admissible", *f, *delta,
             answer.tolerance.value_or(0), *answer.admissible};
  }
  std::vector<Figure> figures{region_of(task_of(report), answer, point, report.catalogue)};
  if (f && delta) {
    figures.push_back(damper_figure(task_of(report), *f, *delta, answer.works_for));
  }
  return figures;
}

HtmlPage page(const RegionReport& report) {
  HtmlPage page = page_of(document(report, Verbosity::full));
  page.figures = drawings(report);
  return page;
}

std::vector<Figure> drawings(const MotionReport& report) {
  const DrawnMotion motion(design::shown_motion(report.request, report.answer));
  return has_figures(motion) ? drawings_of(report, motion) : std::vector<Figure>{};
}

HtmlPage page(const MotionReport& report) {
  HtmlPage page = page_of(document(report, Verbosity::full));
  const DrawnMotion motion(design::shown_motion(report.request, report.answer));
  if (!has_figures(motion)) {
    page.verdict += " Nothing moves, so there is nothing to draw.";
    return page;
  }
  if (!motion.whole) {
    page.verdict += " The figures show the beginning of the motion.";
  }
  page.figures = drawings_of(report, motion);
  return page;
}

}  // namespace stillpoint::report
