// SPDX-License-Identifier: MIT
#include "choices.hpp"
#include "figures/motion_figures.hpp"
#include "figures/report_figures.hpp"

#include <stillpoint/design/suite_view.hpp>
#include <stillpoint/report/record_design.hpp>

#include <iterator>

namespace stillpoint::report {

namespace {

/// The load below its motion.
void add_load(std::vector<Figure>& figures, const DrawnMotion& motion, const Excitation& excitation,
              const FigureUnits& units, bool worst, std::string id) {
  Figure load = excitation_figure(excitation, motion, units);
  load.id = std::move(id);
  if (!worst) {
    load.height = 70;
    load.y.label = "W, g";
    for (FigureArea& band : load.areas) {
      band.name.clear();  // it stands above
    }
  }
  figures.push_back(std::move(load));
}

/// The motion of a case and its load below it; the worst one is large.
void add_motion(std::vector<Figure>& figures, const design::RecordDesign& result,
                std::size_t in_case, std::size_t index, const FigureUnits& units) {
  const design::RecordDesignRequest& task = result.request;
  const design::LoadCase& load_case = task.cases[in_case];
  const std::vector<design::CaseMotion> motions = design::motions_of(load_case);
  const SimulationRequest request = motion_of(task, result.finding->point.damper, motions[index]);
  const bool worst = index == worst_motion(result, in_case);
  const std::string of_case = task.cases.size() == 1 ? "" : format("case-{}-", in_case + 1);
  const std::string id = format("{}record-{}", of_case, index + 1);
  DrawnMotion motion(design::shown_motion(request));
  if (motion.states.back().tau == 0) {  // a hit that the notch takes whole
    return;
  }
  // The limit of a mean bounds no single record. One so far beyond the motion that it would be hard
  // to see is left out; but a motion of next to nothing is shown as that.
  constexpr double nothing = 0.01;
  const double far = worst ? 6 : 3;
  const double peak = result.finding->responses[in_case][index].peak_amplitude;
  const double limit = load_case.limits.peak.value_or(HUGE_VAL);
  if (*load_case.combine == design::Combine::max &&
      (limit <= far * peak || peak < nothing * limit)) {
    motion.beta = load_case.limits.peak;
  }
  const design::SuiteBox& box = result.finding->box;
  if (box.samples > 1) {
    const auto& of = box.of[in_case].front();
    motion.others.push_back(
        {.name = "worst stroke in tolerance",
         .path = beside(
             motion,
             design::shown_motion(
                 motion_of(task, of,
                           design::weakened(motions[index], design::load_part(task, in_case, of))))
                 .states),
         .ink = Ink::orange});
  }
  const bool first_of_many = worst && motions.size() > 1;
  const std::string label = scaled_name(motions[index].name, motions[index].scale);
  Figure drawn = motion_figure(motion, units);
  drawn.id = first_of_many ? of_case + "worst" : id;
  drawn.title =
      (load_case.name.empty() ? "" : load_case.name + ": ") +
      (first_of_many ? load_case.of_records() ? "The worst record: " : "The worst: " : "") + label;
  if (!worst) {
    drawn.height = 130;
  }
  figures.push_back(std::move(drawn));
  if (!load_case.v0) {
    add_load(figures, motion, request.excitation, units, worst,
             (worst ? of_case + "worst" : id) + "-load");
  }
  if (worst && motion.moves()) {
    figures.push_back(loop_figure(request.excitation, motion, units));
    figures.back().id = of_case + "loop";
    figures.back().title =
        (load_case.name.empty() ? "" : load_case.name + ": ") + figures.back().title;
  }
}

}  // namespace

std::vector<Figure> drawings(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const FigureUnits units = units_of(report.physical);
  std::vector<Figure> figures = record_maps(result, units);
  if (!result.finding) {
    return figures;
  }
  if (result.trade_off.size() > 1) {
    std::ranges::move(trade_off_figures(front_of(result), traded(result.nearest), units),
                      std::back_inserter(figures));
  }
  const std::vector<design::LoadCase>& cases = result.request.cases;
  for (std::size_t in_case = 0; in_case < cases.size(); ++in_case) {
    const std::size_t worst = worst_motion(result, in_case);
    const std::size_t count =
        cases[in_case].of_records() ? result.finding->responses[in_case].size() : 0;
    add_motion(figures, result, in_case, worst, units);
    for (std::size_t i = 0; i < std::min<std::size_t>(most_drawn_records, count); ++i) {
      if (i != worst) {
        add_motion(figures, result, in_case, i, units);
      }
    }
  }
  if (cases.size() == 1 && cases.front().of_records()) {
    std::ranges::move(
        spectrum_figures(spectrum_about(result, 0), units, result.finding->point.damper.p),
        std::back_inserter(figures));
  }
  return figures;
}

}  // namespace stillpoint::report
