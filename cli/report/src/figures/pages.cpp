// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "figures/motion_figures.hpp"
#include "figures/region_figures.hpp"

#include <iterator>

namespace stillpoint::report {

namespace {

/// Of one that moves; of a mass that stands still, only a load that it withstands.
std::vector<Figure> drawn(const DrawnMotion& motion, const Excitation& load,
                          const FigureUnits& units, bool with_transmitted) {
  const bool forced = !std::holds_alternative<NoExcitation>(load);
  std::vector<Figure> figures;
  if (motion.states.back().tau == 0) {
    return figures;
  }
  figures.push_back(motion_figure(motion, units));
  if (forced) {
    figures.push_back(excitation_figure(load, motion, units));
  }
  if (motion.moves() && with_transmitted) {
    figures.push_back(transmitted_figure(load, motion, units));
  }
  if (motion.moves()) {
    figures.push_back(loop_figure(load, motion, units));
    figures.push_back(phase_figure(motion, units));
  }
  if (!forced) {
    figures.push_back(energy_figure(motion, units));
  }
  return figures;
}

/// What the design does after its hit, or under its pulse, with the notch that will be built,
/// beside the motion with the paper's where that can be seen.
std::vector<Figure> told_figures(const DesignReport& report, const FigureUnits& units) {
  const design::ShownDamper shown = shown_damper(report.result, report.built_notch);
  SimulationRequest request = motion_of(shown);
  DrawnMotion motion(design::shown_motion(request));
  if (const std::string which = shown_motion(shown, report.physical); !which.empty()) {
    motion.with = format("With {}, ", which);
  }
  motion.beta = shown.problem.beta;
  if (shown.built != nullptr) {
    request.oscillator.hold.reset();
    request.surface.notch_width.reset();
    std::vector<State> ideal = design::shown_motion(request).states;
    if (!is_long(motion) && is_apart(motion, ideal)) {
      motion.others.push_back({.name = format("notch that {}", ideal_words(shown)),
                               .path = beside(motion, std::move(ideal)),
                               .ink = Ink::purple,
                               .dash = Dash::dashed});
    }
  }
  std::vector<Figure> figures = drawn(motion, request.excitation, units, false);
  if (shown.pulse) {
    figures.front().id = "pulse";
    figures.front().title = "Motion under the pulse itself";
  }
  return figures;
}

}  // namespace

std::vector<Figure> drawings(const DesignReport& report) {
  const FigureUnits units = units_of(report.physical);
  const ShownTask task = task_of(report);
  const auto& found = report.result.finding;
  const auto damper = found ? std::optional(DrawnDamper{found->point, "design"}) : std::nullopt;
  std::vector<Figure> all{region_figure(task, report.result, damper, report.catalogue)};
  if (!found) {
    return all;
  }
  if (report.trade_off && report.trade_off->size() > 1) {
    const design::Figures of = design::figures_of(found->response);
    const auto& [f, delta, tolerance] = found->point;
    const Traded chosen{{task.problem.p, f, delta}, tolerance, {}, {}, of.peak, of.acceleration};
    std::ranges::move(trade_off_figures(front_of(report), chosen, units), std::back_inserter(all));
  }
  all.push_back(ends_figure(task, found->point.f, found->point.delta, found->works_for));
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
    point = {{*f, *delta, answer.tolerance.value_or(0)},
             *answer.admissible ? "point, admissible" : "point, not admissible",
             *answer.admissible};
  }
  std::vector<Figure> figures{region_figure(task_of(report), answer, point, report.catalogue)};
  if (f && delta) {
    figures.push_back(ends_figure(task_of(report), *f, *delta, answer.works_for));
  }
  return figures;
}

std::vector<Figure> drawings(const MotionReport& report) {
  return drawn(DrawnMotion(design::shown_motion(report.request, report.answer)),
               report.request.excitation, units_of(report.physical), true);
}

}  // namespace stillpoint::report
