// SPDX-License-Identifier: MIT
// Reads the parts of a reduced sweep, as reduction.cpp writes them, and joins them.

#include "json/sweep_parts.hpp"

#include <stillpoint/core/cancellation.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/file_error.hpp>
#include <stillpoint/records/text_file.hpp>
#include <stillpoint/report/reduction.hpp>
#include <stillpoint/sweep/json_text.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <system_error>

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

std::size_t place_of(const std::vector<RowColumn>& columns, const ordered_json& name) {
  const auto found = std::ranges::find(columns, name.get<std::string>(), &RowColumn::name);
  if (found == columns.end()) {
    throw std::runtime_error("not a column");
  }
  return static_cast<std::size_t>(found - columns.begin());
}

ReducedColumn column_from(const ordered_json& column, const std::vector<RowColumn>& columns) {
  ReducedColumn result(place_of(columns, column.at("column")));
  sweep::read_integers(column.at("count"), result.count);
  sweep::read_integers(column.at("absent"), result.absent);
  sweep::read_integers(column.at("infinite"), result.infinite);
  for (const auto& [key, extreme] :
       {std::pair{"least", &result.least}, {"largest", &result.largest}}) {
    if (const ordered_json& row = column.at(key); !row.is_null()) {
      extreme->add(row_from(row, columns));
    }
  }
  return result;
}

Histogram histogram_from(const ordered_json& histogram, const std::vector<RowColumn>& columns) {
  Histogram result{.column = place_of(columns, histogram.at("column")), .edges = {}, .counts = {}};
  histogram.at("edges").get_to(result.edges);
  sweep::read_integers(histogram.at("counts"), result.counts);
  sweep::read_integers(histogram.at("below"), result.below);
  sweep::read_integers(histogram.at("above"), result.above);
  return result;
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

[[noreturn]] void refuse_part(const std::string& path) {
  throw records::FileError({.kind = "part", .path = path},
                           "is not a complete part of a reduced sweep: it is another kind of file, "
                           "was cut short, or has changed");
}

ReductionReport report_from(const ordered_json& document) {
  ReductionReport report;
  report.label.task = document.at("task").dump();
  sweep::read_integers(document.at("part").at("number"), report.label.part.number);
  sweep::read_integers(document.at("part").at("count"), report.label.part.count);
  report.kind = parse<sweep::SweepKind>(document.at("kind").get<std::string>()).value();
  report.split = true;
  sweep::read_integers(document.at("entries"), report.label.whole.entries);
  sweep::read_integers(document.at("list_digest"), report.label.whole.digest);
  sweep::read_integers(document.at("rows"), report.state.rows);
  if (document.at("outcomes").is_null()) {
    sweep::read_integers(document.at("feasible"), report.state.feasible);
  } else {
    outcomes_from_json(document.at("outcomes"), report.state.outcomes);
    outcomes_from_json(document.at("locked_outcomes"), report.state.locked_outcomes);
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
    total.state.locked_outcomes[i] += more.state.locked_outcomes[i];
  }
  add(total.reduction, more.reduction);
}

}  // namespace

std::uint64_t digest_of(const ordered_json& report) {
  sweep::Digest digest;
  for (const char byte : report.dump()) {
    digest.add(static_cast<std::uint64_t>(static_cast<unsigned char>(byte)));
  }
  return digest.value();
}

bool is_reduction(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return file.get() == '{';
}

ReductionReport read_reduction(const std::string& path) {
  constexpr std::size_t largest_file = std::size_t{1} << 30U;
  cancellation_point();
  if (std::error_code unknown; std::filesystem::exists(path, unknown) && !is_reduction(path)) {
    refuse_part(path);
  }
  const std::string text = records::read_text_file("part", path, largest_file);
  try {
    sweep::require_json_object(text, {.kind = "part", .path = path});
    auto document = ordered_json::parse(text);
    const ordered_json digest = document.at("digest");
    document.erase("digest");
    if (document.at("schema") != reduction_schema || digest != digest_of(document)) {
      throw std::runtime_error("not a part");
    }
    ReductionReport report = report_from(document);
    report.label.path = path;
    if (report.label.rows() != report.state.rows) {
      throw std::runtime_error("not that part");
    }
    return report;
  } catch (const std::exception&) {
    refuse_part(path);
  }
}

std::optional<ReductionReport> find_reduction(const sweep::SweepSpec& spec) {
  if (!spec.part) {
    if (spec.resume) {
      throw InputError("resume", "true", "cannot be combined with reduce: give --part as well");
    }
    return std::nullopt;
  }
  auto found = sweep::find_part(label_of(spec), read_reduction);
  return spec.resume ? std::move(found) : std::nullopt;
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
