// SPDX-License-Identifier: MIT
// A reduced sweep as JSON; reduction_parts.cpp reads it.

#include "json/head_fields.hpp"
#include "json/motion_fields.hpp"
#include "json/schema.hpp"
#include "sweep_parts.hpp"

#include <stillpoint/report/reduction.hpp>

#include <stillpoint/report/schemas.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

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

constexpr auto reduction_names = std::to_array<std::string_view>({reduction_schema});
constexpr auto orders = std::to_array<std::string_view>({"largest", "smallest"});

/// A row, and the columns of all.
struct ShownRow {
  ReducedRow row;
  const std::vector<RowColumn>& columns;
};

/// Entries are counted from 1, as in messages.
ordered_json own_json(const ShownRow& now) {
  ordered_json result{{"entry", now.row.entry + 1}};
  for (std::size_t i = 0; i < now.columns.size(); ++i) {
    result[now.columns[i].name] = cell_json(now.row.values[i], now.columns[i].form);
  }
  return result;
}

ordered_json own_schema(const ShownRow* /*row*/) {
  return {{"type", "object"}, {"required", {"entry"}}};
}

/// What is said of a column, and the columns of all.
template <class Part>
struct OfColumn : Part {
  const std::vector<RowColumn>& columns;
};

/// The options that decide the numbers.
struct Task {
  std::string text;
};
ordered_json own_json(const Task& task) {
  return ordered_json::parse(task.text);
}
ordered_json own_schema(const Task* /*task*/) {
  return {{"type", "object"}};
}

/// A field with those of the reduction.
template <class Part>
constexpr auto of_columns(std::vector<Part> Reduction::*parts) {
  return [parts](const ReductionReport& report) {
    std::vector<OfColumn<Part>> shown;
    for (const Part& part : report.reduction.*parts) {
      shown.push_back({part, report.reduction.row});
    }
    return shown;
  };
}

/// An extreme of a column, the best of one.
constexpr auto extreme(BestRows ReducedColumn::*best) {
  return [best](const OfColumn<ReducedColumn>& now) {
    const std::vector<ReducedRow> found = (now.*best).rows();
    return found.empty() ? std::nullopt : std::optional(ShownRow{found.front(), now.columns});
  };
}

/// What `get` gives of a sweep of motions, or of designs.
template <class Get>
constexpr auto only_of(bool designs, Get get) {
  return [designs, get](const ReductionReport& report) {
    return (report.kind == name(sweep::SweepKind::design)) == designs
               ? std::optional(get(report.state))
               : std::nullopt;
  };
}

constexpr auto sweep_kinds = std::to_array<std::string_view>({"free", "forced", "design"});

}  // namespace

}  // namespace stillpoint::report

namespace stillpoint {

template <>
inline constexpr auto fields<report::OfColumn<sweep::ReducedColumn>> = [] {
  using Now = report::OfColumn<sweep::ReducedColumn>;
  return std::tuple{Field{"column", [](const Now& now) { return now.columns[now.column].name; }},
                    Field{"count", &Now::count, "finite values"},
                    Field{"absent", &Now::absent, "values that do not exist"},
                    Field{"infinite", &Now::infinite, "what never happens"},
                    Field{"least", report::extreme(&sweep::ReducedColumn::least)},
                    Field{"largest", report::extreme(&sweep::ReducedColumn::largest)}};
}();

template <>
inline constexpr auto fields<report::OfColumn<sweep::Histogram>> = [] {
  using Now = report::OfColumn<sweep::Histogram>;
  return std::tuple{
      Field{"column", [](const Now& now) { return now.columns[now.column].name; }},
      Field{"edges", &Now::edges, "", {Numbers::all}},
      Field{"counts", &Now::counts, "a bin contains its lower edge, the last one both"},
      Field{"below", &Now::below}, Field{"above", &Now::above}};
}();

template <>
inline constexpr auto fields<report::OfColumn<sweep::BestRows>> = [] {
  using Now = report::OfColumn<sweep::BestRows>;
  return std::tuple{Field{"column", [](const Now& now) { return now.columns[now.column()].name; }},
                    Field{"order",
                          [](const Now& now) { return report::orders.at(now.largest() ? 0 : 1); },
                          "",
                          {.texts = report::orders}},
                    Field{"most", &Now::most, "", {Numbers::from_one}},
                    Field{"rows",
                          [](const Now& now) {
                            std::vector<report::ShownRow> rows;
                            for (const sweep::ReducedRow& row : now.rows()) {
                              rows.push_back({row, now.columns});
                            }
                            return rows;
                          },
                          "best first; rows with the same value are in the order of the sweep"}};
}();

template <>
inline constexpr auto fields<report::ReductionReport> = [] {
  using namespace report;
  using Now = ReductionReport;
  using sweep::PartLabel;
  using sweep::SweepState;
  return std::tuple_cat(head_fields<Now, reduction_names>, std::tuple{
      Field{"kind", &ReductionReport::kind, "", {.texts = sweep_kinds}},
      Field{"part",
            [](const ReductionReport& report) {
              return report.split ? std::optional(report.label.part) : std::nullopt;
            },
            "null for a whole sweep"},
      Field{"entries", in(&Now::label, &PartLabel::whole, &sweep::ListExtent::entries),
            "of the whole sweep"},
      Field{"rows", in(&Now::state, &SweepState::rows), "the entries in this report"},
      Field{"outcomes",
            only_of(false, [](const SweepState& state) { return Outcomes{state.outcomes}; }),
            "how many entries have each; null for designs, like the next two"},
      Field{"locked", only_of(false, [](const SweepState& state) { return state.locked(); }),
            "motions that the notch holds while the load goes on"},
      Field{"locked_outcomes",
            only_of(false, [](const SweepState& state) { return Outcomes{state.locked_outcomes}; }),
            "how many of them have each outcome"},
      Field{"feasible", only_of(true, [](const SweepState& state) { return state.feasible; }),
            "how many designs there are; null for motions"},
      Field{"row",
            [](const ReductionReport& report) {
              std::vector<std::string> names;
              for (const sweep::RowColumn& column : report.reduction.row) {
                names.push_back(column.name);
              }
              return names;
            },
            "the columns of each row below",
            {Numbers::from_one}},
      Field{"columns", of_columns(&Reduction::columns), "of each result that is a number"},
      Field{"histograms", of_columns(&Reduction::histograms)},
      Field{"best", of_columns(&Reduction::best)},
      Field{"list_digest", in(&Now::label, &PartLabel::whole, &sweep::ListExtent::digest),
            "of the entries of a list"},
      Field{"task", [](const ReductionReport& report) { return Task{report.label.task}; },
            "the options that decide the numbers"}});
}();

}  // namespace stillpoint

namespace stillpoint::report {

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
  ordered_json result = object_json(report);
  result["digest"] = report.split ? ordered_json(digest_of(result)) : ordered_json(nullptr);
  return result;
}

ordered_json reduction_report_schema() {
  ordered_json properties = properties_of<ReductionReport>(fields<ReductionReport>);
  properties["digest"] = value_schema<std::optional<std::uint64_t>>();
  properties["digest"]["description"] = "for a part: of everything else in the report";
  return document_schema(reduction_schema, "sweep --reduce --json",
                         "Numbers are dimensionless unless the name of a column ends in a unit",
                         object_schema(std::move(properties)));
}

}  // namespace stillpoint::report
