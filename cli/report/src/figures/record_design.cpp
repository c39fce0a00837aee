// SPDX-License-Identifier: MIT
#include "figures/record_map.hpp"
#include "figures/report_figures.hpp"
#include "figures/spectrum_parts.hpp"
#include "format.hpp"
#include "record_design_parts.hpp"
#include "sections.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;

namespace {

struct DrawnRecord {
  Figure motion;
  Figure load;
};

enum class Height { full, low };

/// A limit so far beyond the motion that it would be hard to see is left out; but a motion of next
/// to nothing is shown as that.
void fit(DrawnMotion& motion, double peak, Height height) {
  constexpr double nothing = 0.01;
  const double far = height == Height::low ? 3 : 6;
  if (motion.beta && *motion.beta > far * peak && peak >= nothing * *motion.beta) {
    motion.beta.reset();
  }
}

DrawnRecord drawn_record(const design::RecordDesign& result, std::size_t index,
                         const FigureUnits& units, Height height = Height::full) {
  const design::RecordDesignRequest& task = result.request;
  const SimulationRequest request = motion_request(result, index);
  DrawnMotion motion = drawn_motion(request, simulate(request));
  if (*task.combine == design::Combine::max) {  // that of a mean bounds no single record
    motion.beta = task.limits.peak;
  }
  fit(motion, result.finding->responses[index].peak_amplitude, height);
  DrawnRecord drawn{motion_figure(motion, units),
                    excitation_figure(request.excitation, motion, units)};
  drawn.motion.id = format("record-{}", index + 1);
  drawn.motion.title = record_label(task.records[index]);
  return drawn;
}

/// The worst one large with its load, then the others small.
void add_records(std::vector<Figure>& figures, const design::RecordDesign& result,
                 const FigureUnits& units) {
  const std::size_t count = result.request.records.size();
  const std::size_t worst_one = worst_record(result);
  DrawnRecord worst = drawn_record(result, worst_one, units);
  if (count > 1) {
    worst.motion.id = "worst";
    worst.motion.title = "The worst record: " + worst.motion.title;
  }
  worst.load.id = "worst-load";
  figures.push_back(std::move(worst.motion));
  figures.push_back(std::move(worst.load));
  constexpr double small = 130;
  for (std::size_t i = 0; i < std::min(most_drawn_records, count); ++i) {
    if (i != worst_one) {
      figures.push_back(drawn_record(result, i, units, Height::low).motion);
      figures.back().height = small;
    }
  }
}

/// Of the chosen damper, from a quarter of its period to twice that.
std::vector<Figure> design_spectra(const design::RecordDesign& result, const FigureUnits& units) {
  constexpr int points = 141;
  constexpr double shortest = 0.25;
  constexpr double longest = 2;
  const design::RecordDesignRequest& task = result.request;
  const design::SuiteDamper& damper = result.finding->point.damper;
  design::SpectrumRequest request{task.records, {},        damper.f,         damper.delta,
                                  task.combine, task.hold, task.notch_width, task.threads};
  for (int i = 0; i < points; ++i) {
    request.p.push_back(damper.p / (shortest + (longest - shortest) * i / (points - 1)));
  }
  return spectrum_figures(design::spectrum(request), units, damper.p);
}

}  // namespace

figures::HtmlPage page(const RecordDesignReport& report) {
  const design::RecordDesign& result = report.result;
  const FigureUnits units(report.physical);
  figures::HtmlPage page = page_of(document(report));
  page.figures = record_maps(result, units);
  if (result.finding) {
    add_records(page.figures, result, units);
    std::ranges::move(design_spectra(result, units), std::back_inserter(page.figures));
  }
  return page;
}

}  // namespace stillpoint::report
