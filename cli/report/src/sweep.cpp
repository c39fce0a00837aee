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

/// The inputs, how the motion ends and what the rows are chosen by: a line has 80 columns.
std::vector<std::string> shown_columns(const ordered_json& found, const ordered_json& chosen_by) {
  std::vector<std::string> shown{"entry"};
  for (const ordered_json& name : found.at("row")) {
    const auto is_name = [&](const ordered_json& column) { return column.at("column") == name; };
    if (name == chosen_by || std::ranges::none_of(found.at("columns"), is_name)) {
      shown.push_back(name);
    }
  }
  return shown;
}

void add_best(Document& made, const ordered_json& best, const ordered_json& found) {
  constexpr std::size_t most_shown = 10;
  const ordered_json& rows = best.at("rows");
  const std::vector<std::string> shown = shown_columns(found, best.at("column"));
  Table table{shown, {}};
  for (std::size_t i = 0; i < std::min(rows.size(), most_shown); ++i) {
    TableRow& row = table.rows.emplace_back();
    for (const std::string& name : shown) {
      row.cells.push_back(cell(rows[i].at(name)));
    }
  }
  Section& section =
      made.section(fmt::format("{} {}", best.at("order") == "largest" ? "Largest" : "Smallest",
                               best.at("column").get<std::string>()),
                   {std::move(table)});
  if (rows.size() > most_shown || shown.size() <= found.at("row").size()) {
    section.line("--json lists all rows and columns.", Tone::faint);
  }
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
    document.answer.row("record", spelled_out(*record));
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
  for (const ordered_json& best : found.at("best")) {
    add_best(made, best, found);
  }
  return made;
}

}  // namespace stillpoint::report
