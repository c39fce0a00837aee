// SPDX-License-Identifier: MIT
#include <stillpoint/report/reduction.hpp>

#include "sweep_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
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

std::vector<std::string> extreme_cells(const BestRows& extreme) {
  const std::vector<ReducedRow> rows = extreme.rows();
  return rows.empty() ? std::vector<std::string>(2, "-")
                      : std::vector{short_number(rows.front().values[extreme.column()]),
                                    fmt::format("{}", rows.front().entry + 1)};
}

void add_columns(Document& made, const Reduction& reduction) {
  Table table{{"column", "least", "entry", "largest", "entry"}, {}};
  for (const ReducedColumn& column : reduction.columns) {
    TableRow row{{reduction.row[column.column].name}};
    const auto add = [&row](const std::vector<std::string>& cells) {
      row.cells.insert(row.cells.end(), cells.begin(), cells.end());
    };
    add(extreme_cells(column.least));
    add(extreme_cells(column.largest));
    table.rows.push_back(std::move(row));
  }
  Section& section = made.section("Columns");
  section.parts.emplace_back(std::move(table));
  section.line("The entries are where the least and the largest are.");
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
  for (const ReducedRow& row : best.rows()) {
    if (table.rows.size() == most_shown) {
      break;
    }
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
                                              reduction.row[best.column()].name));
  section.parts.emplace_back(std::move(table));
  if (best.rows().size() > most_shown || shown.size() < reduction.row.size()) {
    section.line("--json lists all rows and columns.", Tone::faint);
  }
}

}  // namespace

Document document(const ReductionReport& report) {
  Document made = document_of("Sweep without rows", report.state,
                              report.kind == name(sweep::SweepKind::design));
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
