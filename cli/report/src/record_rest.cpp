// SPDX-License-Identifier: MIT
// How the motions of a design under records end.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <stillpoint/design/record_findings.hpp>
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

/// In the unit of the figures.
std::string displacement_cell(const Physical& physical, double length) {
  const FigureUnits units(physical);
  constexpr double least_m = 1e-6;
  return physical && length > 0 && length * physical->scales.length_m < least_m
             ? format("<{:g}", least_m / physical->scales.length_m * units.length)
             : format("{:.5g}", length * units.length);
}

}  // namespace

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
  document.section("Records").parts.emplace_back(std::move(table));
}

}  // namespace stillpoint::report
