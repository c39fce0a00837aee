// SPDX-License-Identifier: MIT
#include "figures/motion_figures.hpp"
#include "figures/report_figures.hpp"
#include "sections.hpp"

#include <stillpoint/design/suite_view.hpp>
#include <stillpoint/report/record_design.hpp>

#include <iterator>

namespace stillpoint::report {

namespace {

/// The motion under a record and its load below it; the worst one is large.
void add_record(std::vector<Figure>& figures, const design::RecordDesign& result, std::size_t index,
                const FigureUnits& units) {
  const design::RecordDesignRequest& task = result.request;
  const SimulationRequest request = motion_of(task, result.finding->point.damper, index);
  const bool worst = index == worst_record(result);
  const std::string id = format("record-{}", index + 1);
  DrawnMotion motion(design::shown_motion(request));
  // The limit of a mean bounds no single record. One so far beyond the motion that it would be hard
  // to see is left out; but a motion of next to nothing is shown as that.
  constexpr double nothing = 0.01;
  const double far = worst ? 6 : 3;
  const double peak = result.finding->responses[index].peak_amplitude;
  const double limit = task.limits.peak.value_or(HUGE_VAL);
  if (*task.combine == design::Combine::max && (limit <= far * peak || peak < nothing * limit)) {
    motion.beta = task.limits.peak;
  }
  const design::SuiteBox& box = result.finding->box;
  if (box.samples > 1) {  // its damper with the worst objective moves too
    const auto& of =
        box.of.at(static_cast<std::size_t>(&minimised(task) - design::suite_figure_kinds.data()));
    motion.others.push_back(
        {.name = "worst within the tolerance",
         .path = beside(motion, design::shown_motion(motion_of(task, of, index)).states),
         .ink = Ink::orange});
  }
  Figure drawn = motion_figure(motion, units);
  Figure load = excitation_figure(request.excitation, motion, units);
  const bool first_of_many = worst && task.records.size() > 1;
  drawn.id = first_of_many ? "worst" : id;
  drawn.title = (first_of_many ? "The worst record: " : "") + record_label(task.records[index]);
  load.id = (worst ? "worst" : id) + "-load";
  if (!worst) {
    drawn.height = 130;
    load.height = 70;
    load.y.label = "W, g";
    for (FigureArea& band : load.areas) {
      band.name.clear();  // it stands above
    }
  }
  figures.push_back(std::move(drawn));
  figures.push_back(std::move(load));
}

}  // namespace

std::vector<Figure> drawings(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const FigureUnits units = units_of(report.physical);
  std::vector<Figure> figures = record_maps(result, units);
  if (result.finding) {
    const std::size_t worst = worst_record(result);
    const std::size_t count = result.request.records.size();
    add_record(figures, result, worst, units);
    for (std::size_t i = 0; i < std::min<std::size_t>(most_drawn_records, count); ++i) {
      if (i != worst) {
        add_record(figures, result, i, units);
      }
    }
    std::ranges::move(
        spectrum_figures(spectrum_about(result), units, result.finding->point.damper.p),
        std::back_inserter(figures));
  }
  return figures;
}

}  // namespace stillpoint::report
