// SPDX-License-Identifier: MIT
#include "block.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/number.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/sweep/axis.hpp>
#include <stillpoint/sweep/reduction.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stillpoint::sweep {

namespace {

using Eigen::Index;

Reduction empty_reduction(const SweepSpec& spec) {
  Reduction reduction;
  const auto place = [&spec](Quantity column) {
    return static_cast<std::size_t>(std::ranges::find(spec.columns, column) - spec.columns.begin());
  };
  reduction.row.reserve(spec.columns.size());
  for (const Quantity column : spec.columns) {
    reduction.row.push_back({std::string(name(column, spec.units)), form(column)});
    if (form(column) == Form::number && contains(results(spec.kind), column)) {
      ReducedColumn& reduced = reduction.columns.emplace_back();
      reduced.column = place(column);
      reduced.least = {.column = reduced.column};
      reduced.largest = {.column = reduced.column, .largest = true};
    }
  }
  reduction.histograms.reserve(spec.reduction->histograms.size());
  for (const BinsRequest& asked : spec.reduction->histograms) {
    reduction.histograms.push_back({.column = place(asked.column),
                                    .edges = asked.edges,
                                    .counts = std::vector<std::int64_t>(asked.edges.size() - 1)});
  }
  reduction.best.reserve(spec.reduction->best.size());
  for (const BestRequest& asked : spec.reduction->best) {
    reduction.best.push_back(
        {place(asked.column), static_cast<std::size_t>(asked.count), asked.largest});
  }
  return reduction;
}

/// Some entries of a block.
struct Share {
  const SweepBlock& block;
  const std::vector<Quantity>& columns;
  Index begin;
  Index end;

  [[nodiscard]] const Eigen::ArrayXd& values(std::size_t column) const {
    return block[columns[column]];
  }
  [[nodiscard]] ReducedRow row(Index i) const {
    ReducedRow row{block.first + i, {}};
    row.values.reserve(columns.size());
    for (const Quantity column : columns) {
      row.values.push_back(block[column][i]);
    }
    return row;
  }
};

/// Entries come in rising order, so of equal values the one that is there is the first.
void reduce(BestRows& best, const Share& share) {
  const Eigen::ArrayXd& values = share.values(best.column);
  double bar = best.bar();
  for (Index i = share.begin; i < share.end; ++i) {
    if (std::isfinite(values[i]) && (best.largest ? values[i] > bar : values[i] < bar)) {
      best.add(share.row(i));
      bar = best.bar();
    }
  }
}

void reduce(ReducedColumn& reduced, const Share& share) {
  const Eigen::ArrayXd& values = share.values(reduced.column);
  for (Index i = share.begin; i < share.end; ++i) {
    ++(std::isfinite(values[i]) ? reduced.count
       : std::isnan(values[i])  ? reduced.absent
                                : reduced.infinite);
  }
  reduce(reduced.least, share);
  reduce(reduced.largest, share);
}

void reduce(Histogram& histogram, const Share& share) {
  const Eigen::ArrayXd& values = share.values(histogram.column);
  const auto& edges = histogram.edges;
  for (Index i = share.begin; i < share.end; ++i) {
    const double value = values[i];
    if (!std::isfinite(value)) {
      continue;
    }
    if (value < edges.front()) {
      ++histogram.below;
    } else if (value > edges.back()) {
      ++histogram.above;
    } else {
      const auto next = std::ranges::upper_bound(edges, value);
      const auto bin = static_cast<std::size_t>(next - edges.begin()) - 1;
      ++histogram.counts[std::min(bin, histogram.counts.size() - 1)];
    }
  }
}

InputError wrong(std::string_view option, std::string_view text, std::string_view bound) {
  return {std::string(option),
          fmt::format("\"{}\"", records::printable(text, records::longest_word)),
          std::string(bound)};
}

/// The column before the first ':', and what follows.
std::pair<Quantity, std::string_view> column_of(std::string_view option, std::string_view text,
                                                const std::vector<Quantity>& columns,
                                                const std::optional<SweepUnits>& units) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view asked = text.substr(0, colon);
  std::vector<Quantity> numbers = columns;
  std::erase_if(numbers, [](Quantity column) { return form(column) != Form::number; });
  for (const Quantity column : numbers) {
    if (name(column, units) == asked) {
      return {column, text.substr(std::min(colon + 1, text.size()))};
    }
  }
  throw wrong(
      option, text,
      fmt::format("must begin with a column of numbers: {}; --times and --columns add others",
                  names(numbers, units)));
}

/// Of what follows the column: a range of N bins has N + 1 edges.
Axis edges_of(std::string_view option, std::string_view text, std::string_view rest) {
  const std::vector<std::string_view> parts = records::split(rest, ':');
  const std::string_view bins =
      parts.size() > 2 ? std::string_view(parts[2].begin(), rest.end()) : "";
  const bool one_bin = bins == "1" || bins == "1:log";
  try {
    const Axis asked =
        parse_axis(option, one_bin ? fmt::format("{},{}", parts[0], parts[1]) : std::string(rest));
    const auto spacing = asked.spacing();
    return spacing ? Axis(asked[0], asked[asked.size() - 1], asked.size() + 1, *spacing) : asked;
  } catch (const InputError&) {
    throw wrong(option, text,
                "must be COLUMN:LOW:HIGH:BINS, COLUMN:LOW:HIGH:BINS:log with LOW > 0, or "
                "COLUMN:EDGE,EDGE,...");
  }
}

}  // namespace

BinsRequest parse_bins(std::string_view text, const std::vector<Quantity>& columns,
                       const std::optional<SweepUnits>& units) {
  const std::string_view option = "histogram";
  const auto [column, rest] = column_of(option, text, columns, units);
  const Axis edges = edges_of(option, text, rest);
  constexpr std::int64_t most_bins = 100'000;  // each thread has its own
  if (edges.size() < 2 || edges.size() > most_bins + 1) {
    throw wrong(option, text, fmt::format("must have 1 to {} bins", most_bins));
  }
  BinsRequest result{column, {}};
  result.edges.reserve(static_cast<std::size_t>(edges.size()));
  for (std::int64_t i = 0; i < edges.size(); ++i) {
    result.edges.push_back(edges[i]);
  }
  if (std::ranges::adjacent_find(result.edges, std::greater_equal()) != result.edges.end()) {
    throw wrong(option, text, "must have increasing edges");
  }
  return result;
}

BestRequest parse_best(std::string_view text, const std::vector<Quantity>& columns,
                       const std::optional<SweepUnits>& units) {
  constexpr std::int64_t most_rows = 100'000;  // each thread keeps as many
  const std::string_view option = "best";
  const auto [column, rest] = column_of(option, text, columns, units);
  const std::size_t colon = std::min(rest.find(':'), rest.size());
  const std::string_view order = rest.substr(colon);
  const auto count = records::scan_integer(rest.substr(0, colon));
  if (!count || (!order.empty() && order != ":largest" && order != ":smallest")) {
    throw wrong(option, text, "must be COLUMN:ROWS, COLUMN:ROWS:smallest or COLUMN:ROWS:largest");
  }
  if (*count < 1 || *count > most_rows) {
    throw wrong(option, text, fmt::format("must ask for 1 to {} rows", most_rows));
  }
  return {column, *count, order == ":largest"};
}

Reducer::Reducer(const SweepSpec& spec, const Reduction& found)
    : columns_(spec.columns),
      shares_(static_cast<std::size_t>(spec.threads), empty_reduction(spec)) {
  if (!found.row.empty()) {
    shares_.front() = found;
  }
}

void Reducer::add(const SweepBlock& block) {
  const auto threads = static_cast<Index>(shares_.size());
  for_each_entry(threads, static_cast<int>(threads), {}, [&](Index thread) {
    Reduction& reduction = shares_[static_cast<std::size_t>(thread)];
    const Share share{block, columns_, block.size * thread / threads,
                      block.size * (thread + 1) / threads};
    for (ReducedColumn& column : reduction.columns) {
      reduce(column, share);
    }
    for (Histogram& histogram : reduction.histograms) {
      reduce(histogram, share);
    }
    for (BestRows& best : reduction.best) {
      reduce(best, share);
    }
  });
}

Reduction Reducer::result() const {
  Reduction total = shares_.front();
  for (std::size_t i = 1; i < shares_.size(); ++i) {
    sweep::add(total, shares_[i]);
  }
  return total;
}

}  // namespace stillpoint::sweep
