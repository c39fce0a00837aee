// SPDX-License-Identifier: MIT
// What a sweep found, with rows in a file or without.

#include <stillpoint/report/reduction.hpp>
#include <stillpoint/report/sweep.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace stillpoint::report {

namespace {

using sweep::BestRows;
using sweep::Form;
using sweep::ReducedColumn;
using sweep::ReducedRow;
using sweep::Reduction;

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "-";
}

/// Its value and its entry.
void add_extreme(std::vector<std::string>& cells, const BestRows& extreme) {
  const std::vector<ReducedRow> rows = extreme.rows();
  cells.push_back(rows.empty() ? "-" : short_number(rows.front().values[extreme.column()]));
  cells.push_back(rows.empty() ? "-" : fmt::format("{}", rows.front().entry + 1));
}

void add_columns(Document& made, const Reduction& reduction) {
  Table table{{"column", "least", "entry", "largest", "entry"}, {}};
  for (const ReducedColumn& column : reduction.columns) {
    std::vector<std::string> cells{reduction.row[column.column].name};
    add_extreme(cells, column.least);
    add_extreme(cells, column.largest);
    table.rows.push_back({std::move(cells)});
  }
  made.section("Columns", std::move(table))
      .line("The entries are where the least and the largest are.");
}

/// The inputs, how the motion ends and what the rows are chosen by: a line has 80 columns.
std::vector<std::size_t> shown_columns(const BestRows& best, const Reduction& reduction) {
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < reduction.row.size(); ++i) {
    if (i == best.column() || std::ranges::find(reduction.columns, i, &ReducedColumn::column) ==
                                  reduction.columns.end()) {
      shown.push_back(i);
    }
  }
  return shown;
}

void add_best(Document& made, const BestRows& best, const Reduction& reduction) {
  constexpr std::size_t most_shown = 10;
  const std::vector<std::size_t> shown = shown_columns(best, reduction);
  Table table{{"entry"}, {}};
  for (const std::size_t i : shown) {
    table.head.push_back(reduction.row[i].name);
  }
  const std::vector<ReducedRow> rows = best.rows();
  for (const ReducedRow& row : std::span(rows).first(std::min(rows.size(), most_shown))) {
    TableRow cells{{fmt::format("{}", row.entry + 1)}};
    for (const std::size_t i : shown) {
      const double value = row.values[i];
      const bool is_outcome = reduction.row[i].form == Form::outcome && std::isfinite(value);
      cells.cells.push_back(
          is_outcome ? std::string(sweep::sweep_outcome_name(static_cast<std::size_t>(value)))
                     : short_number(value));
    }
    table.rows.push_back(std::move(cells));
  }
  Section& section = made.section(fmt::format("{} {}", best.largest() ? "Largest" : "Smallest",
                                              reduction.row[best.column()].name),
                                  std::move(table));
  if (rows.size() > most_shown || shown.size() < reduction.row.size()) {
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
  document.answer.row("time", fmt::format("{:.2g} s on {} thread{}", summary.wall_time_s,
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
  Document made =
      document_of("Sweep without rows", report.state, report.kind == sweep::SweepKind::design);
  if (report.split) {
    made.answer.row("part", text(report.label.part));
  }
  add_columns(made, report.reduction);
  for (const BestRows& best : report.reduction.best) {
    add_best(made, best, report.reduction);
  }
  return made;
}

}  // namespace stillpoint::report
