// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "figures/report_figures.hpp"
#include "sections.hpp"

#include <stillpoint/report/page_frame.hpp>
#include <stillpoint/report/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;
using figures::HtmlPage;
using figures::Ink;

namespace {

/// The design as its pulse moves it, from rest.
DrawnMotion motion_under(const design::Finding& found, double beta) {
  const double p = found.pulse->p;
  const Excitation shaking = design::excitation(found.pulse->pulse);
  const double ends = duration(shaking).value();
  constexpr double periods = 3;  // where it does not stop
  constexpr double behind_the_end = 1.04;
  const double horizon = behind_the_end * found.pulse->response.stop_time.value_or(
                                              ends + periods * 2 * std::numbers::pi / p);
  DrawnMotion motion = drawn_forced_motion({p, found.point.f, found.point.delta}, {0, 0}, shaking,
                                           std::max(horizon, ends));
  motion.beta = beta;
  return motion;
}

/// The answer to a task with a pulse.
HtmlPage pulse_page(HtmlPage page, const DesignReport& report, const FigureUnits& units) {
  const auto& [problem, limits, search, pulse, ranges] = report.result.request;
  DrawnPulseRegion drawn{design::pulse_request(report.result.request).problem,
                         limits,
                         report.result.region,
                         *report.result.intervals,
                         {},
                         {}};
  if (!report.result.finding) {
    const EmptyTask task{problem, limits, pulse, report.physical};
    drawn.mend = mend_title(report.result, task);
    page.verdict += what_would_help(report.result, task);
    page.figures = {pulse_region_figure(drawn, units)};
    if (report.catalogue) {
      add_parts(page.figures.front(), *report.catalogue, units);
    }
    return page;
  }
  const design::Finding& found = *report.result.finding;
  drawn.damper = DrawnDamper{"design", found.point.f, found.point.delta, found.point.tolerance};
  const DrawnMotion motion = motion_under(found, problem.beta);
  Figure figure = motion_figure(motion, units);
  figure.id = "pulse";
  figure.title = "Motion under the pulse itself";
  const double ends = duration(design::excitation(found.pulse->pulse)).value();
  figure.bands.insert(figure.bands.begin(), {"pulse", 0, ends * units.time, Ink::sky});
  page.figures = {pulse_region_figure(drawn, units), figure, phase_figure(motion, units)};
  if (report.catalogue) {
    add_parts(page.figures.front(), *report.catalogue, units);
  }
  return page;
}

}  // namespace

HtmlPage page(const DesignReport& report) {
  const auto& [problem, limits, search, pulse, ranges] = report.result.request;
  const FigureUnits units(report.physical);
  HtmlPage page = page_of(document(report));
  if (pulse) {
    return pulse_page(std::move(page), report, units);
  }
  if (!report.result.finding) {
    const EmptyTask task{problem, limits, pulse, report.physical};
    page.verdict += what_would_help(report.result, task);
    page.figures = {region_figure(
        {problem, limits, report.result.region, {}, mend_title(report.result, task)}, units)};
    if (report.catalogue) {
      add_parts(page.figures.front(), *report.catalogue, units);
    }
    return page;
  }
  const design::Finding& found = *report.result.finding;
  const auto& [f, delta, tolerance] = found.point;
  DrawnMotion motion = drawn_free_motion({problem.p, f, delta}, {0, problem.v0}, {});
  motion.beta = problem.beta;
  page.figures = {
      region_figure(
          {problem, limits, report.result.region, DrawnDamper{"design", f, delta, tolerance}, {}},
          units),
      motion_figure(motion, units), phase_figure(motion, units), energy_figure(motion, units)};
  if (report.catalogue) {
    add_parts(page.figures.front(), *report.catalogue, units);
  }
  page.figures.insert(page.figures.begin() + 1,
                      hits_figure(problem, f, delta, found.works_for, units));
  if (report.trade_off && report.trade_off->size() > 1) {
    auto front = trade_off_figures(*report.trade_off, found, units);
    page.figures.insert(page.figures.begin() + 1, front.begin(), front.end());
  }
  return page;
}

std::vector<Figure> drawings(const RegionReport& report) {
  const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
  const design::RegionAnswer& answer = report.answer;
  const FigureUnits units(report.physical);
  std::optional<DrawnDamper> point;
  if (answer.admissible) {
    point = {*answer.admissible ? "point, admissible" : "point, not admissible", *f, *delta,
             answer.tolerance.value_or(0)};
  }
  const std::string mend =
      answer.region.feasible ? "" : mend_title(answer, {problem, limits, pulse, report.physical});
  std::vector<Figure> figures{
      pulse ? pulse_region_figure({design::pulse_request(report.request).problem, limits,
                                   answer.region, *answer.intervals, point, mend},
                                  units)
            : region_figure({problem, limits, answer.region, point, mend}, units)};
  if (report.catalogue) {
    add_parts(figures.front(), *report.catalogue, units);
  }
  if (f && delta && !pulse) {
    figures.push_back(hits_figure(problem, *f, *delta, answer.works_for, units));
  }
  return figures;
}

HtmlPage page(const RegionReport& report) {
  HtmlPage page = page_of(document(report));
  if (!report.answer.region.feasible) {
    const auto& [problem, limits, f, delta, pulse, ranges] = report.request;
    page.verdict += what_would_help(report.answer, {problem, limits, pulse, report.physical});
  }
  page.figures = drawings(report);
  return page;
}

namespace {

std::vector<Figure> drawings_of(const MotionReport& report, const DrawnMotion& motion) {
  const FigureUnits units(report.physical);
  std::vector<Figure> figures{motion_figure(motion, units)};
  if (is_forced(report.request)) {
    figures.push_back(excitation_figure(report.request.excitation, motion, units));
  }
  figures.push_back(phase_figure(motion, units));
  if (!is_forced(report.request) && report.request.surface.plain()) {
    figures.push_back(energy_figure(motion, units));
  }
  return figures;
}

bool moves(const DrawnMotion& motion) {
  return motion.states.back().tau > 0;
}

}  // namespace

std::vector<Figure> drawings(const MotionReport& report) {
  const DrawnMotion motion = drawn_motion(report.request, report.answer);
  return moves(motion) ? drawings_of(report, motion) : std::vector<Figure>{};
}

HtmlPage page(const MotionReport& report) {
  HtmlPage page = page_of(document(report));
  const DrawnMotion motion = drawn_motion(report.request, report.answer);
  if (!moves(motion)) {
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
