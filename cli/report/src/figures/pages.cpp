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

/// With the notch that will be built, beside the motion with the paper's where that can be seen.
DrawnMotion told(const design::ShownDamper& shown) {
  SimulationRequest request = motion_of(shown);
  DrawnMotion motion(design::shown_motion(request));
  if (shown.built != nullptr) {
    request.oscillator.hold.reset();
    request.surface.notch_width.reset();
    add_if_visible(motion, {.name = format("notch that {}", ideal_words(shown)),
                            .states = design::shown_motion(request).states,
                            .ink = figures::Ink::purple,
                            .dash = figures::Dash::dashed});
  }
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

/// Of one that moves; of a mass that stands still, only a load that it withstands.
std::vector<Figure> drawn(const DrawnMotion& motion, const Excitation& load,
                          const FigureUnits& units) {
  const bool forced = !std::holds_alternative<NoExcitation>(load);
  std::vector<Figure> figures;
  if (motion.states.back().tau == 0) {
    return figures;
  }
  figures.push_back(motion_figure(motion, units));
  if (forced) {
    figures.push_back(excitation_figure(load, motion, units));
  }
  if (is_moving(motion)) {
    figures.push_back(phase_figure(motion, units));
  }
  if (!forced) {
    figures.push_back(energy_figure(motion, units));
  }
  return figures;
}

/// What the design does after its hit, or under its pulse.
std::vector<Figure> told_figures(const DesignReport& report, const FigureUnits& units) {
  const design::ShownDamper shown = shown_damper(report.result, report.built_notch);
  DrawnMotion motion = told(shown);
  if (const std::string which = shown_motion(shown, report.physical); !which.empty()) {
    motion.with = fmt::format("With {}, ", which);
  }
  motion.beta = report.result.request.problem.beta;
  std::vector<Figure> figures = drawn(motion, motion_of(shown).excitation, units);
  if (shown.pulse) {
    figures.front().id = "pulse";
    figures.front().title = "Motion under the pulse itself";
  }
  return figures;
}

}  // namespace

std::vector<Figure> drawings(const DesignReport& report) {
  const FigureUnits units = units_of(report.physical);
  const auto& found = report.result.finding;
  std::optional<DrawnDamper> damper;
  if (found) {
    const auto& [f, delta, tolerance] = found->point;
    damper = DrawnDamper{"design", f, delta, tolerance};
  }
  std::vector<Figure> all{region_of(task_of(report), report.result, damper, report.catalogue)};
  if (!found) {
    return all;
  }
  std::ranges::move(damper_figures(report, units), std::back_inserter(all));
  for (Figure& figure : all) {
    if (report.built_notch && !figure.clauses.empty()) {  // which the captions are not of
      figure.clauses.front() += format(
          ", with a notch that {}", ideal_words(shown_damper(report.result, report.built_notch)));
    }
  }
  std::ranges::move(told_figures(report, units), std::back_inserter(all));
  return all;
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

std::vector<Figure> drawings(const MotionReport& report) {
  return drawn(DrawnMotion(design::shown_motion(report.request, report.answer)),
               report.request.excitation, units_of(report.physical));
}

HtmlPage page(const MotionReport& report) {
  HtmlPage page = page_of(document(report, Verbosity::full));
  const DrawnMotion motion(design::shown_motion(report.request, report.answer));
  page.figures = drawn(motion, report.request.excitation, units_of(report.physical));
  page.verdict += page.figures.empty() ? " Nothing moves, so there is nothing to draw."
                  : motion.whole       ? ""
                                       : " The figures show the beginning of the motion.";
  return page;
}

}  // namespace stillpoint::report
