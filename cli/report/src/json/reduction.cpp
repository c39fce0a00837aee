// SPDX-License-Identifier: MIT
#include "json/part_files.hpp"
#include "json/parts.hpp"
#include "sweep_parts.hpp"

#include <stillpoint/report/reduction.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

namespace stillpoint::report {

namespace {

using nlohmann::ordered_json;
using sweep::BestRows;
using sweep::FineBins;
using sweep::Form;
using sweep::Histogram;
using sweep::ReducedColumn;
using sweep::ReducedRow;
using sweep::Reduction;
using sweep::RowColumn;

constexpr auto reduction_schema = "stillpoint/sweep-reduction/1";
constexpr std::array quantile_shares{0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99};

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

double value_from(const ordered_json& value) {
  if (value.is_boolean()) {
    return value.get<bool>() ? 1 : 0;
  }
  if (value.is_string()) {
    for (std::size_t i = 0; i < sweep::sweep_outcome_count; ++i) {
      if (value == sweep::sweep_outcome_name(i)) {
        return static_cast<double>(i);
      }
    }
    throw std::runtime_error("not an outcome");
  }
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

/// Entries are counted from 1, as in messages.
ordered_json row_json(const ReducedRow& row, const std::vector<RowColumn>& columns) {
  ordered_json result{{"entry", row.entry + 1}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    result[columns[i].name] = value_json(row.values[i], columns[i].form);
  }
  return result;
}

ReducedRow row_from(const ordered_json& row, const std::vector<RowColumn>& columns) {
  ReducedRow result;
  sweep::read_integers(row.at("entry"), result.entry);
  if (result.entry < 1) {
    throw std::runtime_error("an entry below 1");
  }
  --result.entry;
  result.values.reserve(columns.size());
  for (const RowColumn& column : columns) {
    result.values.push_back(value_from(row.at(column.name)));
  }
  return result;
}

std::optional<ReducedRow> extreme_from(const ordered_json& row,
                                       const std::vector<RowColumn>& columns) {
  return row.is_null() ? std::nullopt : std::optional(row_from(row, columns));
}

ordered_json quantiles_json(const Reduction& reduction, const ReducedColumn& column) {
  ordered_json result = ordered_json::array();
  for (const double share : quantile_shares) {
    if (const auto bounds = quantile(reduction, column, share)) {
      result.push_back({{"share", share}, {"low", bounds->first}, {"high", bounds->second}});
    }
  }
  return result;
}

ordered_json column_json(const Reduction& reduction, const ReducedColumn& column) {
  const auto row = [&](const ReducedRow& extreme) { return row_json(extreme, reduction.row); };
  const auto bin_json = [](const FineBins::Bin& bin) -> ordered_json {
    return {bin.low, bin.high, bin.count};
  };
  return {{"column", reduction.row[column.column].name},
          {"count", column.count},
          {"absent", column.absent},
          {"infinite", column.infinite},
          {"least", or_null(column.least, row)},
          {"largest", or_null(column.largest, row)},
          {"quantiles", quantiles_json(reduction, column)},
          {"bins", list_json(column.bins.filled(), bin_json)}};
}

std::size_t place_of(const std::vector<RowColumn>& columns, const ordered_json& name) {
  const auto found = std::ranges::find(columns, name.get<std::string>(), &RowColumn::name);
  if (found == columns.end()) {
    throw std::runtime_error("not a column");
  }
  return static_cast<std::size_t>(found - columns.begin());
}

ReducedColumn column_from(const ordered_json& column, const std::vector<RowColumn>& columns) {
  ReducedColumn result{.column = place_of(columns, column.at("column"))};
  sweep::read_integers(column.at("count"), result.count);
  sweep::read_integers(column.at("absent"), result.absent);
  sweep::read_integers(column.at("infinite"), result.infinite);
  result.least = extreme_from(column.at("least"), columns);
  result.largest = extreme_from(column.at("largest"), columns);
  for (const ordered_json& bin : column.at("bins")) {
    // The end that is nearer to 0 is in the bin.
    const double low = bin.at(0).get<double>();
    std::int64_t count = 0;
    sweep::read_integers(bin.at(2), count);
    result.bins.add(low < 0 ? bin.at(1).get<double>() : low, count);
  }
  return result;
}

ordered_json histogram_json(const Histogram& histogram, const std::vector<RowColumn>& columns) {
  return {{"column", columns[histogram.column].name},
          {"edges", histogram.edges},
          {"counts", histogram.counts},
          {"below", histogram.below},
          {"above", histogram.above}};
}

Histogram histogram_from(const ordered_json& histogram, const std::vector<RowColumn>& columns) {
  Histogram result{.column = place_of(columns, histogram.at("column")), .edges = {}, .counts = {}};
  histogram.at("edges").get_to(result.edges);
  sweep::read_integers(histogram.at("counts"), result.counts);
  sweep::read_integers(histogram.at("below"), result.below);
  sweep::read_integers(histogram.at("above"), result.above);
  return result;
}

ordered_json best_json(const BestRows& best, const std::vector<RowColumn>& columns) {
  const auto best_row = [&](const ReducedRow& row) { return row_json(row, columns); };
  return {{"column", columns[best.column()].name},
          {"order", best.largest() ? "largest" : "smallest"},
          {"most", best.most()},
          {"rows", list_json(best.rows(), best_row)}};
}

BestRows best_from(const ordered_json& best, const std::vector<RowColumn>& columns) {
  std::size_t most = 0;
  sweep::read_integers(best.at("most"), most);
  BestRows result(place_of(columns, best.at("column")), most, best.at("order") == "largest");
  for (const ordered_json& row : best.at("rows")) {
    result.add(row_from(row, columns));
  }
  return result;
}

std::vector<RowColumn> columns_from(const ordered_json& columns) {
  std::vector<RowColumn> result;
  result.reserve(columns.size());
  for (const ordered_json& name : columns) {
    result.push_back({name.get<std::string>(), Form::number});
    for (const sweep::QuantityForm& known : sweep::quantity_forms) {
      if (result.back().name == known.name) {
        result.back().form = known.form;
      }
    }
  }
  return result;
}

ReductionReport report_from(const ordered_json& document) {
  ReductionReport report;
  document.at("kind").get_to(report.kind);
  report.split = true;
  sweep::read_integers(document.at("entries"), report.label.whole.entries);
  sweep::read_integers(document.at("list_digest"), report.label.whole.digest);
  sweep::read_integers(document.at("rows"), report.state.rows);
  if (document.at("outcomes").is_null()) {
    sweep::read_integers(document.at("feasible"), report.state.feasible);
  } else {
    outcomes_from_json(document.at("outcomes"), report.state);
  }
  Reduction& reduction = report.reduction;
  reduction.row = columns_from(document.at("row"));
  for (const ordered_json& column : document.at("columns")) {
    reduction.columns.push_back(column_from(column, reduction.row));
  }
  for (const ordered_json& histogram : document.at("histograms")) {
    reduction.histograms.push_back(histogram_from(histogram, reduction.row));
  }
  for (const ordered_json& best : document.at("best")) {
    reduction.best.push_back(best_from(best, reduction.row));
  }
  return report;
}

void append(ReductionReport& total, const ReductionReport& more) {
  total.state.rows += more.state.rows;
  total.state.feasible += more.state.feasible;
  for (std::size_t i = 0; i < sweep::sweep_outcome_count; ++i) {
    total.state.outcomes[i] += more.state.outcomes[i];
  }
  add(total.reduction, more.reduction);
}

}  // namespace

ordered_json digest_json(const ordered_json& report) {
  sweep::ByteDigest digest;
  digest.add(report.dump());
  return {digest.words, digest.rest, digest.size};
}

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
      {"outcomes", design ? ordered_json(nullptr) : outcomes_json(report.state)},
      {"feasible", design ? ordered_json(report.state.feasible) : ordered_json(nullptr)},
      {"row", list_json(row, [](const RowColumn& column) { return column.name; })},
      {"columns",
       list_json(reduction.columns,
                 [&](const ReducedColumn& column) { return column_json(reduction, column); })},
      {"histograms",
       list_json(reduction.histograms,
                 [&](const Histogram& histogram) { return histogram_json(histogram, row); })},
      {"best",
       list_json(reduction.best, [&](const BestRows& best) { return best_json(best, row); })},
      {"list_digest", report.label.whole.digest},
      {"task", ordered_json::parse(report.label.task)}};
  result["digest"] = report.split ? digest_json(result) : ordered_json(nullptr);
  return result;
}

bool is_reduction(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return file.get() == '{';
}

ReductionReport read_reduction(const std::string& path) {
  return read_part(path, reduction_schema, "a reduced sweep", report_from,
                   [](const ReductionReport& report) { return report.state.rows; });
}

std::optional<ReductionReport> find_reduction(const sweep::PartLabel& wanted) {
  return sweep::find_part(wanted, "sweep", read_reduction);
}

ReductionReport merged(const std::vector<std::string>& parts) {
  sweep::PartOrder order;
  std::optional<ReductionReport> total;
  for (const std::string& path : parts) {
    ReductionReport part = read_reduction(path);
    order.add(part.label);
    if (total) {
      append(*total, part);
    } else {
      total = std::move(part);
    }
  }
  static_cast<void>(order.places());
  total->split = false;
  return *std::move(total);
}

}  // namespace stillpoint::report
