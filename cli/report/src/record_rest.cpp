// SPDX-License-Identifier: MIT
// How the motions of a design under records end.
#include "format.hpp"
#include "record_design_parts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
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

}  // namespace

std::string lock_words(const design::RecordDesign& result) {
  std::size_t count = 0;
  double most = 0;
  for (const ForcedResponse& response : result.finding->responses) {
    if (response.locked_from) {
      ++count;
      most = std::max(most, *response.largest_load_while_locked);
    }
  }
  const std::size_t all = result.finding->responses.size();
  return count == 0 ? ""
                    : format("under {} the notch holds the mass to the end, and transmits up to {}",
                             of_records(count, all), acceleration_shown(most));
}

void add_rest(Section& answer, const design::RecordDesign& result) {
  const std::vector<ForcedResponse>& all = result.finding->responses;
  std::string words;
  for (const auto& [end, what] : {std::pair{RecordEnd::notch, "held by the notch to the end of "},
                                  {RecordEnd::friction, "held by friction to the end of "},
                                  {RecordEnd::moving, "after the load of "}}) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      count += record_end(result.request.records[i].record, all[i]) == end ? 1U : 0U;
    }
    if (count > 0) {
      words += (words.empty() ? "" : "; ") + (what + of_records(count, all.size()));
    }
  }
  answer.row("rest", words);
}

void add_records(Document& document, const design::RecordDesign& result, const Physical& physical) {
  constexpr std::array held_by{"notch", "friction", "no load"};
  const FigureUnits units(physical);
  Table table{{"record", "PGA, g", in("peak", units.length_unit), in("residual", units.length_unit),
               "transmitted, g", in("rests from", units.time_unit), "held by"},
              {}};
  for (std::size_t i = 0; i < result.finding->responses.size(); ++i) {
    const ForcedResponse& response = result.finding->responses[i];
    const design::SuiteFigures figures = design::suite_figures(response);
    const design::SuiteRecord& record = result.request.records[i];
    table.rows.push_back(
        {{record_label(record), format("{:.4g}", design::peak_load(record)),
          format("{:.5g}", figures.peak * units.length),
          format("{:.5g}", figures.residual * units.length), format("{:.4g}", figures.acceleration),
          format("{:.5g}", *response.stop_time * units.time),
          held_by.at(static_cast<std::size_t>(record_end(record.record, response)))}});
  }
  document.section("Records").parts.emplace_back(std::move(table));
}

}  // namespace stillpoint::report
