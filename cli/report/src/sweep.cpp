// SPDX-License-Identifier: MIT
// What a sweep found, with rows in a file or without.

#include <stillpoint/report/reduction.hpp>
#include <stillpoint/report/sweep.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;

/// With few digits; a text as it is.
std::string cell(const ordered_json& value) {
  return value.is_null()      ? "-"
         : value.is_boolean() ? fmt::format("{:d}", value.get<bool>())
         : value.is_number()  ? fmt::format("{:.6g}", value.get<double>())
                              : value.get<std::string>();
}

void add_columns(Document& made, const ordered_json& columns) {
  Table table{{"column", "least", "entry", "largest", "entry"}, {}};
  for (const ordered_json& column : columns) {
    const std::string name = column.at("column");
    std::vector<std::string> cells{name};
    for (const ordered_json& row : {column.at("least"), column.at("largest")}) {
      cells.push_back(cell(row.is_null() ? row : row.at(name)));
      cells.push_back(cell(row.is_null() ? row : row.at("entry")));
    }
    table.rows.push_back({std::move(cells)});
  }
  made.section("Columns", {std::move(table)})
      .line("The entries are where the least and the largest are.");
}

/// With how many entries ended in each way.
Document document_of(std::string title, const sweep::SweepState& state, bool design) {
  return {.title = std::move(title),
          .verdict = summary(state, design),
          .tone = state.locked() > 0 ? Tone::bad : Tone::plain};
}

}  // namespace

Document document(const SweepReport& report) {
  const auto& [spec, summary, map, record] = report;
  Document document = document_of("Sweep", summary.state, spec.kind == sweep::SweepKind::design);
  if (record) {
    // Several are a column of the rows.
    const auto more = std::ranges::count(*record, '\n');
    document.answer.row(more > 0 ? "records" : "record",
                        more > 0 ? format("{} files", more + 1) : spelled_out(*record));
  }
  if (summary.resumed_at > 0) {
    document.answer.row("resumed at", fmt::format("{} rows", summary.resumed_at));
  }
  const double took = summary.wall_time_s;
  document.answer.row("time", fmt::format("{:.{}f} s on {} thread{}", took,
                                          took < 0.1  ? 4
                                          : took < 10 ? 2
                                                      : 0,
                                          spec.threads, spec.threads == 1 ? "" : "s"));
  return document;
}

std::string progress_words(double rows, std::int64_t begun_with,
                           const std::optional<std::int64_t>& total, double seconds) {
  const double per_second = (rows - static_cast<double>(begun_with)) / seconds;
  if (!total) {
    return fmt::format("{:.4g} rows, {:.3g} rows/s", rows, per_second);
  }
  const auto all = static_cast<double>(*total);
  return fmt::format("{:.4g} of {:.4g} rows, {:.0f} %, {:.3g} rows/s", rows, all, 100 * rows / all,
                     per_second);
}

Document document(const ReductionReport& report) {
  Document made = document_of("Sweep without rows", report.found.state,
                              report.found.kind == sweep::SweepKind::design);
  const ordered_json found = json(report);
  if (report.part) {
    made.answer.row("part", text(*report.part));
  }
  add_columns(made, found.at("columns"));
  return made;
}

}  // namespace stillpoint::report
