// SPDX-License-Identifier: MIT
// A reduced sweep as JSON.

#include "json/head_fields.hpp"
#include "json/sweep_parts.hpp"

#include <stillpoint/report/reduction.hpp>

#include <cmath>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;
using sweep::Form;
using sweep::Histogram;
using sweep::ReducedColumn;
using sweep::ReducedRow;
using sweep::Reduction;
using sweep::RowColumn;

/// Null for what does not exist or never happens.
ordered_json cell_json(double value, Form form) {
  return !std::isfinite(value) ? ordered_json(nullptr)
         : form == Form::outcome
             ? ordered_json(sweep::sweep_outcome_name(static_cast<std::size_t>(value)))
         : form == Form::truth ? ordered_json(value != 0)
                               : ordered_json(value);
}

constexpr auto reduction_names = std::to_array<std::string_view>({"stillpoint/sweep-reduction/1"});

ordered_json row_schema() {
  return {{"type", "object"}, {"required", {"entry"}}};
}
using ShownRow = Printed<row_schema>;
using Columns = const std::vector<RowColumn>&;

/// Entries are counted from 1, as in messages.
ShownRow shown(const ReducedRow& row, Columns columns) {
  ordered_json result{{"entry", row.entry + 1}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    result[columns[i].name] = cell_json(row.values[i], columns[i].form);
  }
  return {std::move(result)};
}
constexpr auto extreme(ReducedRow ReducedColumn::*row) {
  return [row](const auto& now) {
    return (now.*row).values.empty() ? std::nullopt : std::optional(shown(now.*row, now.columns));
  };
}
/// What is said of a column, and the columns of all.
struct ShownColumn : ReducedColumn {
  Columns columns;

  using Now = ShownColumn;
  static constexpr std::tuple field_table{
      Field{"column", [](const auto& now) { return now.columns[now.column].name; }},
      Field{"count", &Now::count, "finite values"},
      Field{"absent", &Now::absent, "values that do not exist"},
      Field{"infinite", &Now::infinite, "what never happens"},
      Field{"least", extreme(&ReducedColumn::least)},
      Field{"largest", extreme(&ReducedColumn::largest)}};
};
struct ShownHistogram : Histogram {
  Columns columns;

  using Now = ShownHistogram;
  static constexpr std::tuple field_table{
      Field{"column", [](const auto& now) { return now.columns[now.column].name; }},
      Field{"edges", &Now::edges, "", any_number},
      Field{"counts", &Now::counts, "a bin contains its lower edge, the last one both"},
      Field{"below", &Now::below}, Field{"above", &Now::above}};
};
ordered_json task_schema() {
  return {{"type", "object"}};
}

/// A field with those of the reduction.
template <class Shown>
constexpr auto of_columns(auto parts) {
  return [parts](const ReductionReport& now) {
    const Reduction& reduction = now.found.state.reduction;
    const auto with_row = [&](const auto& part) { return Shown{part, reduction.row}; };
    return mapped(reduction.*parts, with_row);
  };
}

constexpr auto reduction_table = [] {
  using Now = ReductionReport;
  using sweep::Checkpoint;
  using sweep::SweepState;
  constexpr auto kind = in(&Now::found, &Checkpoint::kind);
  constexpr auto state = in(&Now::found, &Checkpoint::state);
  return std::tuple_cat(
      head_fields<Now, reduction_names>,
      std::tuple{Field{"kind", kind}, Field{"part", &Now::part, "null for a whole sweep"},
                 Field{"entries", in(&Now::found, &Checkpoint::whole, &sweep::ListExtent::entries),
                       "of the whole sweep"},
                 Field{"rows", in(state, &SweepState::rows), "the entries in this report"}},
      ended_fields(kind, state),
      std::tuple{Field{"locked_outcomes",
                       only_of(false, kind, state, in(&SweepState::locked_outcomes, &outcomes_of)),
                       "how many of the locked motions have each outcome; null for designs"},
                 Field{"row",
                       [](const Now& now) {
                         return mapped(now.found.state.reduction.row, &RowColumn::name);
                       },
                       "the columns of the rows below", at_least_one},
                 Field{"columns", of_columns<ShownColumn>(&Reduction::columns),
                       "of each result that is a number"},
                 Field{"histograms", of_columns<ShownHistogram>(&Reduction::histograms)},
                 Field{"task",
                       [](const Now& now) {
                         return Printed<task_schema>{ordered_json::parse(now.found.task)};
                       },
                       "the options that decide the numbers"}});
}();

}  // namespace

ReductionReport reduction_report(const sweep::SweepSpec& spec, const sweep::SweepSummary& summary) {
  ReductionReport report{beginning(spec), spec.part};
  report.found.state = summary.state;
  if (!spec.part) {  // a list has not been counted before
    report.found.whole = {summary.state.rows, summary.state.digest};
  }
  return report;
}

ordered_json json(const ReductionReport& report) {
  return object_by<reduction_table>(report);
}

ordered_json reduction_report_schema() {
  return report_schema<ReductionReport>(
      reduction_table, reduction_names.front(), "sweep --reduce --json",
      "Numbers are dimensionless unless the name of a column ends in a unit");
}

}  // namespace stillpoint::report
