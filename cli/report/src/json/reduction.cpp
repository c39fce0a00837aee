// SPDX-License-Identifier: MIT
// A reduced sweep as JSON; reduction_parts.cpp reads it.

#include "json/parts.hpp"
#include "sweep_parts.hpp"

#include <stillpoint/report/reduction.hpp>

#include <cmath>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;
using sweep::BestRows;
using sweep::Form;
using sweep::Histogram;
using sweep::ReducedColumn;
using sweep::ReducedRow;
using sweep::Reduction;
using sweep::RowColumn;

/// Null for what does not exist or never happens.
ordered_json value_json(double value, Form form) {
  if (!std::isfinite(value)) {
    return nullptr;
  }
  switch (form) {
    case Form::number:
      break;
    case Form::outcome:
      return sweep::sweep_outcome_name(static_cast<std::size_t>(value));
    case Form::truth:
      return value != 0;
  }
  return value;
}

/// Entries are counted from 1, as in messages.
ordered_json row_json(const ReducedRow& row, const std::vector<RowColumn>& columns) {
  ordered_json result{{"entry", row.entry + 1}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    result[columns[i].name] = value_json(row.values[i], columns[i].form);
  }
  return result;
}

ordered_json column_json(const ReducedColumn& column, const std::vector<RowColumn>& columns) {
  const auto row = [&](const BestRows& extreme) {
    const std::vector<ReducedRow> found = extreme.rows();
    return found.empty() ? ordered_json(nullptr) : row_json(found.front(), columns);
  };
  return {{"column", columns[column.column].name},
          {"count", column.count},
          {"absent", column.absent},
          {"infinite", column.infinite},
          {"least", row(column.least)},
          {"largest", row(column.largest)}};
}

ordered_json histogram_json(const Histogram& histogram, const std::vector<RowColumn>& columns) {
  return {{"column", columns[histogram.column].name},
          {"edges", histogram.edges},
          {"counts", histogram.counts},
          {"below", histogram.below},
          {"above", histogram.above}};
}

ordered_json best_json(const BestRows& best, const std::vector<RowColumn>& columns) {
  const auto best_row = [&](const ReducedRow& row) { return row_json(row, columns); };
  return {{"column", columns[best.column()].name},
          {"order", best.largest() ? "largest" : "smallest"},
          {"most", best.most()},
          {"rows", list_json(best.rows(), best_row)}};
}

}  // namespace

ReductionReport reduction_report(const sweep::SweepSpec& spec, const sweep::SweepSummary& summary,
                                 Reduction reduction) {
  sweep::PartLabel label = label_of(spec);
  if (!spec.part) {
    label.whole.entries = summary.state.rows;
    label.whole.digest = summary.state.digest;
  }
  return {std::string(name(spec.kind)), spec.part.has_value(), std::move(label), summary.state,
          std::move(reduction)};
}

ordered_json json(const ReductionReport& report) {
  const bool design = report.kind == name(sweep::SweepKind::design);
  const auto& [number, count] = report.label.part;
  const Reduction& reduction = report.reduction;
  const auto& row = reduction.row;
  const ordered_json part{{"number", number}, {"count", count}};
  ordered_json result{
      {"schema", reduction_schema},
      {"program", program_json()},
      {"kind", report.kind},
      {"part", report.split ? part : ordered_json(nullptr)},
      {"entries", report.label.whole.entries},
      {"rows", report.state.rows},
      {"outcomes", design ? ordered_json(nullptr) : outcomes_json(report.state.outcomes)},
      {"locked", design ? ordered_json(nullptr) : ordered_json(report.state.locked())},
      {"locked_outcomes",
       design ? ordered_json(nullptr) : outcomes_json(report.state.locked_outcomes)},
      {"feasible", design ? ordered_json(report.state.feasible) : ordered_json(nullptr)},
      {"row", list_json(row, [](const RowColumn& column) { return column.name; })},
      {"columns", list_json(reduction.columns,
                            [&](const ReducedColumn& column) { return column_json(column, row); })},
      {"histograms",
       list_json(reduction.histograms,
                 [&](const Histogram& histogram) { return histogram_json(histogram, row); })},
      {"best",
       list_json(reduction.best, [&](const BestRows& best) { return best_json(best, row); })},
      {"list_digest", report.label.whole.digest},
      {"task", ordered_json::parse(report.label.task)}};
  result["digest"] = report.split ? ordered_json(digest_of(result)) : ordered_json(nullptr);
  return result;
}

}  // namespace stillpoint::report
