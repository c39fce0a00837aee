// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "report_figures.hpp"

#include <stillpoint/report/report.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stillpoint::report {

using figures::Figure;
using figures::HtmlPage;
using figures::Ink;

namespace {

HtmlPage page_of(const Document& document) {
  return {.title = document.title,
          .verdict = document.verdict,
          .answer = html(document.answer),
          .figures = {},
          .body = html(document),
          .report = text(document, {.verbosity = Verbosity::full}),
          .footer = {}};
}

/// "max-displacement must be at least 0.127 m", rounded so that the value helps.
std::string words_of(const design::Mend& mend, const Physical& physical) {
  const auto words = [](std::string_view name, double value, bool upwards, std::string_view unit) {
    const double place = std::pow(10, 3 - std::floor(std::log10(value)));  // four digits
    const double safe = (upwards ? std::ceil(value * place) : std::floor(value * place)) / place;
    return fmt::format("{} must be at {} {:.5g}{}{}", name, upwards ? "least" : "most", safe,
                       unit.empty() ? "" : " ", unit);
  };
  if (physical) {
    if (const auto now = physical_mend(*physical, mend)) {
      return words(now->name, now->value, now->upwards, now->unit);
    }
  }
  return words(mend.field, mend.value, mend.upwards, "");
}

/// Where nothing is admissible: the title of the region's figure. The page's verdict says what
/// would help.
std::string mend_title(HtmlPage& page, const design::RegionVerdict& empty,
                       const Physical& physical) {
  std::string title = "No damper is admissible";
  if (!empty.mends.empty()) {
    const auto of_beta = std::ranges::find(empty.mends, "beta", &design::Mend::field);
    const design::Mend& mend = of_beta == empty.mends.end() ? empty.mends.front() : *of_beta;
    title = "No damper: " + words_of(mend, physical);
    page.verdict += fmt::format(" To get one, {}.", words_of(mend, physical));
  } else if (empty.joint_mend) {
    std::string all;
    for (const design::Mend& mend : empty.joint_mend->mends) {
      all += (all.empty() ? "" : " and ") + words_of(mend, physical);
    }
    page.verdict += fmt::format(" To get one, {}.", all);
  }
  return title;
}

void add_empty_region(HtmlPage& page, DrawnRegion drawn, const design::RegionVerdict& empty,
                      const Physical& physical) {
  drawn.mend = mend_title(page, empty, physical);
  page.figures = {region_figure(drawn, FigureUnits(physical))};
}

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
                         report.result.intervals,
                         {},
                         {}};
  if (!report.result.finding) {
    drawn.mend = mend_title(page, report.result, report.physical);
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
    add_empty_region(page, {problem, limits, report.result.region, {}, {}}, report.result,
                     report.physical);
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

HtmlPage page(const RegionReport& report) {
  const auto& [problem, limits, f, delta] = report.request;
  const design::RegionAnswer& answer = report.answer;
  HtmlPage page = page_of(document(report));
  std::optional<DrawnDamper> damper;
  if (answer.admissible) {
    damper = {*answer.admissible ? "point, admissible" : "point, not admissible", *f, *delta,
              answer.tolerance.value_or(0)};
  }
  const DrawnRegion drawn{problem, limits, answer.region, damper, {}};
  if (answer.region.feasible) {
    page.figures = {region_figure(drawn, FigureUnits(report.physical))};
  } else {
    add_empty_region(page, drawn, answer, report.physical);
  }
  if (report.catalogue) {
    add_parts(page.figures.front(), *report.catalogue, FigureUnits(report.physical));
  }
  if (f && delta) {
    page.figures.push_back(
        hits_figure(problem, *f, *delta, answer.works_for, FigureUnits(report.physical)));
  }
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
  page.figures = {motion_figure(motion, units)};
  if (is_forced(report.request)) {
    page.figures.push_back(excitation_figure(report.request.excitation, motion, units));
  }
  page.figures.push_back(phase_figure(motion, units));
  if (!is_forced(report.request) && report.request.surface.plain()) {
    page.figures.push_back(energy_figure(motion, units));
  }
  return page;
}

}  // namespace stillpoint::report
