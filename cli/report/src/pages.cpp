// SPDX-License-Identifier: MIT
#include "report_figures.hpp"

#include <stillpoint/report/report.hpp>

#include <algorithm>
#include <numbers>

namespace stillpoint::report {

using figures::Figure;
using figures::HtmlPage;
using figures::Ink;

namespace {

HtmlPage page_of(const Document& document) {
  return {.title = document.title,
          .verdict = document.verdict,
          .figures = {},
          .body = html(document),
          .footer = {}};
}

std::optional<design::PulseProblem> pulse_problem(const design::DesignRequest& request) {
  const auto& [problem, limits, search, pulse] = request;
  return pulse ? std::optional(
                     design::PulseProblem{*pulse, problem.p, problem.beta, problem.criterion})
               : std::nullopt;
}

/// The design as its pulse moves it, from rest.
Figure pulse_figure(const design::Pulse& pulse, const design::Problem& problem,
                    const design::Finding& found, const FigureUnits& units) {
  const Excitation shaking = design::excitation(pulse);
  const double ends = duration(shaking).value();
  constexpr double periods = 3;  // where it does not stop
  constexpr double behind_the_end = 1.04;
  const double horizon = behind_the_end * found.pulse->response.stop_time.value_or(
                                              ends + periods * 2 * std::numbers::pi / problem.p);
  DrawnMotion motion = drawn_forced_motion({problem.p, found.point.f, found.point.delta}, {0, 0},
                                           shaking, std::max(horizon, ends));
  motion.beta = problem.beta;
  Figure figure = motion_figure(motion, units);
  figure.id = "pulse";
  figure.title = "Motion under the pulse itself";
  figure.bands.insert(figure.bands.begin(), {"pulse", 0, ends * units.time, Ink::sky});
  return figure;
}

}  // namespace

HtmlPage page(const DesignReport& report) {
  const auto& [problem, limits, search, pulse] = report.result.request;
  const FigureUnits units(report.physical);
  HtmlPage page = page_of(document(report));
  if (!report.result.finding) {
    page.figures = {region_figure({problem, limits, report.result.region, {}, {}}, units)};
    return page;
  }
  const design::Finding& found = *report.result.finding;
  const auto& [f, delta, tolerance] = found.point;
  DrawnMotion motion = drawn_free_motion({problem.p, f, delta}, {0, problem.v0}, {});
  motion.beta = problem.beta;
  page.figures = {region_figure({problem, limits, report.result.region,
                                 DrawnDamper{"design", f, delta, tolerance},
                                 pulse_problem(report.result.request)},
                                units),
                  motion_figure(motion, units), phase_figure(motion, units),
                  energy_figure(motion, units)};
  if (found.pulse) {
    for (Figure& figure : page.figures) {
      figure.title += figure.id == "region" ? "" : ", reduced to v0";
    }
    page.figures.push_back(pulse_figure(*pulse, problem, found, units));
  }
  return page;
}

HtmlPage page(const RegionReport& report) {
  const auto& [problem, limits, f, delta] = report.request;
  const design::RegionAnswer& answer = report.answer;
  HtmlPage page = page_of(document(report));
  std::optional<DrawnDamper> damper;
  if (answer.admissible) {
    damper = {*answer.admissible ? "point, admissible" : "point, not admissible", *f, *delta,
              answer.tolerance.value_or(0)};
  }
  page.figures = {
      region_figure({problem, limits, answer.region, damper, {}}, FigureUnits(report.physical))};
  return page;
}

HtmlPage page(const MotionReport& report) {
  const FigureUnits units(report.physical);
  HtmlPage page = page_of(document(report));
  const DrawnMotion motion = drawn_motion(report.request, report.answer);
  if (motion.states.back().tau == 0) {
    page.verdict += " Nothing moves, so there is nothing to draw.";
    return page;
  }
  if (!motion.whole) {
    page.verdict += " The figures show the beginning of the motion.";
  }
  page.figures = {motion_figure(motion, units), phase_figure(motion, units)};
  if (is_forced(report.request)) {
    page.figures.push_back(excitation_figure(report.request.excitation, motion, units));
  } else if (report.request.surface.plain()) {
    page.figures.push_back(energy_figure(motion, units));
  }
  return page;
}

}  // namespace stillpoint::report
