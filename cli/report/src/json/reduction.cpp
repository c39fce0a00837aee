// SPDX-License-Identifier: MIT
// A reduced sweep as JSON; reduction_parts.cpp reads it.

#include "json/head_fields.hpp"
#include "json/sweep_parts.hpp"

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
ordered_json cell_json(double value, Form form) {
  return !std::isfinite(value) ? ordered_json(nullptr)
         : form == Form::outcome
             ? ordered_json(sweep::sweep_outcome_name(static_cast<std::size_t>(value)))
         : form == Form::truth ? ordered_json(value != 0)
                               : ordered_json(value);
}

constexpr auto reduction_names = std::to_array<std::string_view>({reduction_schema});
constexpr auto orders = std::to_array<std::string_view>({"largest", "smallest"});

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
std::vector<ShownRow> shown(const BestRows& best, Columns columns) {
  return mapped(best.rows(), [&](const ReducedRow& row) { return shown(row, columns); });
}

/// The best of one.
constexpr auto extreme(BestRows ReducedColumn::*best) {
  return [best](const auto& now) {
    const std::vector<ShownRow> found = shown(now.*best, now.columns);
    return found.empty() ? std::nullopt : std::optional(found.front());
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
struct ShownBest : BestRows {
  Columns columns;

  using Now = ShownBest;
  static constexpr std::tuple field_table{
      Field{"column", [](const auto& now) { return now.columns[now.column()].name; }},
      Field{"order", [](const auto& now) { return orders.at(now.largest() ? 0 : 1); }, "",
            one_of(orders)},
      Field{"most", &Now::most, "", at_least_one},
      Field{"rows", [](const auto& now) { return shown(now, now.columns); },
            "best first; rows with the same value are in the order of the sweep"}};
};

ordered_json task_schema() {
  return {{"type", "object"}};
}

struct Reduced : ReductionReport {
  std::optional<sweep::SweepPart> part;  ///< of a sweep in parts
  const Reduction& reduction;
};
/// A field with those of the reduction.
template <class Shown>
constexpr auto of_columns(auto parts) {
  return [parts](const Reduced& now) {
    const auto with_row = [&now](const auto& part) { return Shown{part, now.reduction.row}; };
    return mapped(now.reduction.*parts, with_row);
  };
}

constexpr auto reduction_table = [] {
  using Now = Reduced;
  using sweep::PartLabel;
  using sweep::SweepState;
  constexpr auto of_motions = [](auto get) { return only_of(false, &Now::kind, &Now::state, get); };
  return std::tuple_cat(
      head_fields<Now, reduction_names>,
      std::tuple{
          Field{"kind", &Now::kind}, Field{"part", &Now::part, "null for a whole sweep"},
          Field{"entries", in(&Now::label, &PartLabel::whole, &sweep::ListExtent::entries),
                "of the whole sweep"},
          Field{"rows", in(&Now::state, &SweepState::rows), "the entries in this report"},
          Field{"outcomes", of_motions(in(&SweepState::outcomes, &outcomes_of)),
                "how many entries have each; null for designs, like the next two"},
          Field{"locked", of_motions(&SweepState::locked),
                "motions that the notch holds while the load goes on"},
          Field{"locked_outcomes", of_motions(in(&SweepState::locked_outcomes, &outcomes_of)),
                "how many of them have each outcome"},
          Field{"feasible", only_of(true, &Now::kind, &Now::state, &SweepState::feasible),
                "how many designs there are; null for motions"},
          Field{"row", [](const Now& now) { return mapped(now.reduction.row, &RowColumn::name); },
                "the columns of each row below", at_least_one},
          Field{"columns", of_columns<ShownColumn>(&Reduction::columns),
                "of each result that is a number"},
          Field{"histograms", of_columns<ShownHistogram>(&Reduction::histograms)},
          Field{"best", of_columns<ShownBest>(&Reduction::best)},
          Field{"list_digest", in(&Now::label, &PartLabel::whole, &sweep::ListExtent::digest),
                "of the entries of a list"},
          Field{"task",
                [](const Now&
                       now) { return Printed<task_schema>{ordered_json::parse(now.label.task)}; },
                "the options that decide the numbers"},
          Field{"digest", [](const Now&) { return std::optional<std::uint64_t>(); },
                "for a part: of everything else in the report"}});
}();

}  // namespace

ReductionReport reduction_report(const sweep::SweepSpec& spec, const sweep::SweepSummary& summary,
                                 const Reduction& reduction) {
  Reduced reduced{{label_of(spec), spec.kind, summary.state, {}}, spec.part, reduction};
  ReductionReport& report = reduced;
  if (!spec.part) {
    report.label.whole = {summary.state.rows, summary.state.digest};
  }
  report.found = object_by<reduction_table>(reduced);
  return std::move(report);
}

ordered_json json(const ReductionReport& report) {
  ordered_json result = report.found;
  result.erase("digest");
  const bool part = !result.at("part").is_null();
  result["digest"] = part ? ordered_json(digest_of(result)) : ordered_json(nullptr);
  return result;
}

ordered_json reduction_report_schema() {
  return report_schema<Reduced>(
      reduction_table, reduction_schema, "sweep --reduce --json",
      "Numbers are dimensionless unless the name of a column ends in a unit");
}

}  // namespace stillpoint::report
