// SPDX-License-Identifier: MIT
// How the motions of a design under records end.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <stillpoint/report/digits.hpp>
#include <stillpoint/report/record_design.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

/// What the mass does when the load of its record ends.
enum class RecordEnd { notch, friction, moving };

/// From when on the load is 0.
double load_end(Record record) {
  auto& [values, step, times] = record;
  while (values.size() > 1 && values.back() == 0 && values[values.size() - 2] == 0) {
    values.pop_back();
  }
  times.resize(times.empty() ? 0 : values.size());
  return duration(Excitation(record)).value();
}

RecordEnd record_end(const Record& record, const ForcedResponse& response) {
  return response.locked_from                             ? RecordEnd::notch
         : response.stop_time.value() <= load_end(record) ? RecordEnd::friction
                                                          : RecordEnd::moving;
}

/// A length, and the least that a report tells from 0.
constexpr double least_m = 1e-6;
bool is_too_small(const Physical& physical, double length) {
  return physical && length > 0 && length * physical->scales.length_m < least_m;
}

/// In the unit of the figures.
std::string displacement_cell(const Physical& physical, double length) {
  const FigureUnits units(physical);
  return is_too_small(physical, length)
             ? format("<{:g}", least_m / physical->scales.length_m * units.length)
             : format("{:.5g}", length * units.length);
}

/// What the structure feels while the notch holds the mass to the end.
double most_while_locked(const std::vector<ForcedResponse>& all) {
  double most = 0;
  for (const ForcedResponse& response : all) {
    most = std::max(most, response.locked_from ? *response.largest_load_while_locked : 0);
  }
  return most;
}

}  // namespace

std::string displacement_shown(const Physical& physical, double length, std::optional<int> digits) {
  return is_too_small(physical, length) ? "less than " + with_unit(least_m, "m")
                                        : length_shown(physical, length, digits);
}

std::string lock_words(const design::RecordDesign& result) {
  const std::vector<ForcedResponse>& all = result.finding->responses;
  const auto count = static_cast<std::size_t>(std::ranges::count_if(
      all, [](const ForcedResponse& response) { return response.locked_from.has_value(); }));
  return count == 0
             ? ""
             : format("locked in the notch to the end of {}; the structure then feels up to {}",
                      of_records(count, all.size()), acceleration_shown(most_while_locked(all)));
}

void add_rest(Section& answer, const design::RecordDesign& result) {
  const std::vector<ForcedResponse>& all = result.finding->responses;
  std::string words;
  for (const auto& [end, what] : {std::pair{RecordEnd::notch, "by the notch to the end of "},
                                  {RecordEnd::friction, "by friction to the end of "},
                                  {RecordEnd::moving, "after the load of "}}) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      count += record_end(result.request.records[i].record, all[i]) == end ? 1U : 0U;
    }
    if (count > 0) {
      words += (words.empty() ? "" : "; ") + std::string(what) + of_records(count, all.size());
    }
  }
  answer.row("rest", words);
}

void add_worst_of_mean(Section& answer, const design::RecordDesign& result,
                       const Physical& physical) {
  if (!is_mean(result.request)) {
    return;
  }
  const std::size_t worst = worst_record(result);
  answer.row(
      "worst record",
      format("{}: {}", record_label(result.request.records[worst]),
             figures_words(design::suite_figures(result.finding->responses[worst]), physical)));
  for (const design::SuiteFigureKind& kind : design::suite_figure_kinds) {
    const std::optional<double>& limit = result.request.limits.*kind.limit;
    std::string words;
    for (std::size_t i = 0; limit && i < result.finding->responses.size(); ++i) {
      const double value = design::suite_figures(result.finding->responses[i]).*kind.value;
      if (value > *limit) {
        words +=
            format("{}{} under {}", words.empty() ? "" : ", ", figure_shown(physical, kind, value),
                   record_label(result.request.records[i]));
      }
    }
    if (!words.empty()) {
      answer.row("exceeds",
                 format("{} {}, where the mean may be {}", kind.words, words,
                        figure_shown(physical, kind, *limit)),
                 Tone::bad);
    }
  }
}

void add_records(Document& document, const design::RecordDesign& result, const Physical& physical) {
  constexpr std::array rests{"by notch", "by friction", "after load"};
  const FigureUnits units(physical);
  Table table{{"record", "PGA, g", in("peak", units.length_unit), in("residual", units.length_unit),
               "transmitted, g", in("rests from", units.time_unit), "at rest"},
              {}};
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    const ForcedResponse& response = result.finding->responses[i];
    const design::SuiteFigures figures = design::suite_figures(response);
    const design::SuiteRecord& record = result.request.records[i];
    table.rows.push_back(
        {{record_label(record), format("{:.4g}", design::peak_load(record)),
          displacement_cell(physical, figures.peak), displacement_cell(physical, figures.residual),
          format("{:.4g}", figures.acceleration),
          format("{:.5g}", *response.stop_time * units.time),
          rests.at(static_cast<std::size_t>(record_end(record.record, response)))}});
  }
  Section& section = document.section("Records");
  section.parts.emplace_back(std::move(table));
  const design::SuiteDamper& damper = result.finding->point.damper;
  add_jumps_note(section, damper.delta, notch_of(result.request, damper).width);
}

}  // namespace stillpoint::report
