// SPDX-License-Identifier: MIT
#include "figures/report_figures.hpp"
#include "figures/spectrum_parts.hpp"
#include "format.hpp"
#include "record_design_parts.hpp"
#include "sections.hpp"

#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

using figures::Figure;

namespace {

using design::SuiteFigures;
using design::SuiteLimits;

/// The objective from least to largest, then what is broken, which is hatched: more red than blue.
constexpr std::array shades{"#0b4f8a", "#2f7fc1", "#6aaede", "#9ecae9", "#c6dff2", "#e6f1fa"};
constexpr std::array broken{"#ef8a2b", "#fbd3a4", "#f7b267", "#8a7a68"};
constexpr std::array broken_names{"stroke too large", "transmits too much", "residual too large",
                                  "never rests, or may stop elsewhere"};

/// The first of broken_names, in the order of design::suite_figure_kinds, that is true; their
/// number where the limits are met.
std::size_t broken_index(const SuiteFigures& figures, const SuiteLimits& limits) {
  const auto& kinds = design::suite_figure_kinds;
  const auto* const violated =
      std::ranges::find_if(kinds, [&](const design::SuiteFigureKind& kind) {
        const std::optional<double>& limit = limits.*kind.limit;
        return figures.settled && limit && figures.*kind.value > *limit;
      });
  return admissible(figures, limits) ? broken.size()
                                     : static_cast<std::size_t>(violated - kinds.begin());
}

/// About the damper, but not beyond the range.
Interval shown_range(const Interval& range, double chosen) {
  constexpr double around = 3;
  constexpr double least_part = 0.1;
  return {range.low,
          std::min(range.high,
                   std::max(around * chosen, range.low + least_part * (range.high - range.low)))};
}

std::string objective_words(const design::RecordDesignRequest& task, double value,
                            const FigureUnits& units) {
  return task.objective == design::SuiteObjective::acceleration ? format("{:.3g} g", value)
                                                                : units.length_words(value);
}

/// "No damper: allow a stroke of 62.1 mm": the first limit that would be enough alone.
std::string shortfall_title(const design::RecordDesign& result, const FigureUnits& units) {
  for (const auto& [which, limit, nearest, relaxed] : result.shortfalls) {
    if (relaxed) {
      return which == design::SuiteObjective::acceleration
                 ? format("No damper: allow {:.4g} g to be transmitted", *relaxed)
                 : format("No damper: allow a {} of {}", quantity(which),
                          units.length_words(*relaxed));
    }
  }
  return "No damper meets the limits";
}

/// The values of the objective where every limit is met, the damper's own included, which may be
/// better than any cell; none if least > most.
struct ShownValues {
  double least{HUGE_VAL};
  double most{0};

  /// Of one shade.
  [[nodiscard]] double width() const {
    return most > least ? (most - least) / static_cast<double>(shades.size()) : 1;
  }
};

ShownValues shown_values(const design::SuiteMap& map, const SuiteFigures& of_damper,
                         const design::RecordDesignRequest& task) {
  ShownValues shown;
  const auto include = [&](const SuiteFigures& figures) {
    if (admissible(figures, task.limits)) {
      shown.least = std::min(shown.least, value_of(figures, task.objective));
      shown.most = std::max(shown.most, value_of(figures, task.objective));
    }
  };
  include(of_damper);
  std::ranges::for_each(map.figures, include);
  return shown;
}

/// Each cell has the shade of its value, or the colour of the first limit that it violates.
void add_cells(figures::FigureMap& drawn, const design::SuiteMap& map, const ShownValues& shown,
               const design::RecordDesignRequest& task) {
  drawn.columns = static_cast<std::int64_t>(map.f.size());
  drawn.rows = static_cast<std::int64_t>(map.delta.size());
  for (std::size_t row = 0; row < map.delta.size(); ++row) {
    for (std::size_t column = 0; column < map.f.size(); ++column) {
      const SuiteFigures& figures = map.figures[column * map.delta.size() + row];
      const std::size_t fault = broken_index(figures, task.limits);
      const double place = (value_of(figures, task.objective) - shown.least) / shown.width();
      const std::size_t shade = fault < broken.size()
                                    ? shades.size() + fault
                                    : std::min(static_cast<std::size_t>(place), shades.size() - 1);
      drawn.cells.push_back(static_cast<std::uint8_t>(shade));
    }
  }
}

void add_shades(figures::FigureMap& drawn, const ShownValues& shown,
                const design::RecordDesignRequest& task, const FigureUnits& units) {
  const auto words = [&](double value) { return objective_words(task, value, units); };
  const auto& [least, most] = shown;
  for (std::size_t i = 0; i < shades.size(); ++i) {
    drawn.palette.emplace_back(shades.at(i));
    const double from = least + shown.width() * static_cast<double>(i);
    drawn.labels.push_back(least < most ? "≈ " + words(from + shown.width() / 2) : "");
    drawn.names.push_back(least < most
                              ? format("{} to {}", words(from), words(from + shown.width()))
                          : least == most && i == 0 ? words(least)
                                                    : "");
  }
  if (least < most) {
    drawn.key.push_back({"from " + words(least), shades.front()});
    drawn.key.push_back({"to " + words(most), shades.back()});
  } else if (least == most) {
    drawn.key.push_back({words(least), shades.front()});
  }
}

/// Of the cell that the damper lies in.
std::uint8_t shade_at(const Figure& drawn, const figures::FigurePoint& place) {
  const auto cell = [](double position, std::int64_t count) {
    return std::clamp(static_cast<std::int64_t>(position * static_cast<double>(count)),
                      std::int64_t{0}, count - 1);
  };
  const std::int64_t row = cell(drawn.y.position(place.y), drawn.map.rows);
  const std::int64_t column = cell(drawn.x.position(place.x), drawn.map.columns);
  return drawn.map.cells[static_cast<std::size_t>(row * drawn.map.columns + column)];
}

/// Whether there are any.
bool add_faults(figures::FigureMap& drawn) {
  bool any = false;
  for (std::size_t i = 0; i < broken.size(); ++i) {
    drawn.labels.emplace_back(broken_names.at(i));
    drawn.palette.emplace_back(broken.at(i));
    drawn.names.emplace_back(broken_names.at(i));
    if (std::ranges::count(drawn.cells, static_cast<std::uint8_t>(shades.size() + i)) > 0) {
      drawn.key.push_back({broken_names.at(i), broken.at(i), true});
      any = true;
    }
  }
  return any;
}

/// Where the search went beyond the map; "" if nowhere.
std::string beyond_words(const design::RecordDesignRequest& searched,
                         const design::RecordDesignRequest& shown, const FigureUnits& units) {
  std::string ends;
  if (shown.f->high < searched.f->high) {
    ends = format("f = {:.3g}", searched.f->high);
  }
  if (shown.delta->high < searched.delta->high) {
    ends +=
        format("{}Δ = {}", ends.empty() ? "" : " and ", units.length_words(searched.delta->high));
  }
  return ends.empty() ? "" : format("; the search reached {}, beyond the map", ends);
}

Figure map_figure(const design::RecordDesign& result, const design::SuitePoint& point,
                  const FigureUnits& units) {
  design::RecordDesignRequest task = result.request;
  task.f = shown_range(*task.f, point.damper.f);
  task.delta = shown_range(*task.delta, point.damper.delta);
  const design::SuiteMap map = design::suite_map(task, point.damper.p);
  const ShownValues shown = shown_values(map, point.figures, task);
  Figure drawn;
  drawn.id = "map";
  drawn.title = !result.finding ? shortfall_title(result, units)
                                : format("The {} over f and Δ{}", quantity(task.objective),
                                         task.p.low < task.p.high ? ", best period" : "");
  drawn.x = {"constant friction f", task.f->low, task.f->high};
  drawn.y = {units.delta_label, task.delta->low * units.length, task.delta->high * units.length};
  add_cells(drawn.map, map, shown, task);
  add_shades(drawn.map, shown, task, units);
  const bool any_fails = add_faults(drawn.map);
  const figures::FigurePoint place{point.damper.f, point.damper.delta * units.length};
  const char* const what = result.finding ? "chosen" : "nearest";
  drawn.marks.push_back({what, {place}, figures::Shape::star, figures::Ink::orange});
  drawn.notes.push_back({what, place});
  drawn.description =
      format("The plane of f and Δ: the {} of the records combined, and where a limit is violated.",
             quantity(task.objective));
  const bool any_meets = shown.least <= shown.most;
  drawn.caption = !any_meets  ? "Each area is named after the first limit violated there"
                  : any_fails ? "What is not hatched meets every limit, the darker the better"
                              : "The darker, the better";
  constexpr std::uint8_t best_shade = 0;
  if (result.finding && shade_at(drawn, place) != best_shade) {
    drawn.caption +=
        "; a cell has the shade of the damper in its middle, and the chosen one is better";
  }
  drawn.caption += beyond_words(result.request, task, units) + ".";
  return drawn;
}

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
  const design::RecordDesignRequest& task = result.request;
  if (task.f->low < task.f->high && task.delta->low < task.delta->high) {
    page.figures.push_back(map_figure(result, result.nearest, units));
  }
  if (result.finding) {
    add_records(page.figures, result, units);
    std::ranges::move(design_spectra(result, units), std::back_inserter(page.figures));
  }
  return page;
}

}  // namespace stillpoint::report
