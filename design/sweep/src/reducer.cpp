// SPDX-License-Identifier: MIT
#include "block.hpp"

#include <stillpoint/core/for_each_entry.hpp>
#include <stillpoint/core/input_error.hpp>
#include <stillpoint/records/text.hpp>
#include <stillpoint/sweep/axis.hpp>
#include <stillpoint/sweep/reduction.hpp>
#include <stillpoint/sweep/spec.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
      reduction.columns.push_back({.column = place(column)});
    }
  }
  reduction.histograms.reserve(spec.reduction->histograms.size());
  for (const BinsRequest& asked : spec.reduction->histograms) {
    reduction.histograms.push_back({.column = place(asked.column),
                                    .edges = asked.edges,
                                    .counts = std::vector<std::int64_t>(asked.edges.size() - 1)});
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
void reduce(ReducedColumn& reduced, const Share& share) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Eigen::ArrayXd& values = share.values(reduced.column);
  const auto value_in = [&](const ReducedRow& row, double none) {
    return row.values.empty() ? none : row.values[reduced.column];
  };
  double least = value_in(reduced.least, infinite);
  double largest = value_in(reduced.largest, -infinite);
  Index least_at = -1;
  Index largest_at = -1;
  for (Index i = share.begin; i < share.end; ++i) {
    const double value = values[i];
    if (!std::isfinite(value)) {
      ++(std::isnan(value) ? reduced.absent : reduced.infinite);
      continue;
    }
    ++reduced.count;
    if (value < least) {
      least = value;
      least_at = i;
    }
    if (value > largest) {
      largest = value;
      largest_at = i;
    }
  }
  if (least_at >= 0) {
    reduced.least = share.row(least_at);
  }
  if (largest_at >= 0) {
    reduced.largest = share.row(largest_at);
  }
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

InputError wrong(std::string_view text, std::string_view bound) {
  return {"histogram", fmt::format("\"{}\"", records::printable(text, records::longest_word)),
          std::string(bound)};
}

Quantity column_of(std::string_view text, std::string_view asked,
                   const std::vector<Quantity>& columns, const std::optional<SweepUnits>& units) {
  std::vector<Quantity> numbers = columns;
  std::erase_if(numbers, [](Quantity column) { return form(column) != Form::number; });
  const auto found =
      std::ranges::find(numbers, asked, [&](Quantity column) { return name(column, units); });
  if (found == numbers.end()) {
    throw wrong(
        text,
        fmt::format("must begin with a column of numbers: {}; --times and --columns add others",
                    names(numbers, units)));
  }
  return *found;
}

/// Of what follows the column: a range of N bins has N + 1 edges.
Axis edges_of(std::string_view text, std::string_view rest) {
  const std::vector<std::string_view> parts = records::split(rest, ':');
  const std::string_view bins =
      parts.size() > 2 ? std::string_view(parts[2].begin(), rest.end()) : "";
  const bool one_bin = bins == "1" || bins == "1:log";
  try {
    const Axis asked = parse_axis(
        "histogram", one_bin ? fmt::format("{},{}", parts[0], parts[1]) : std::string(rest));
    const auto spacing = asked.spacing();
    return spacing ? Axis(asked[0], asked[asked.size() - 1], asked.size() + 1, *spacing) : asked;
  } catch (const InputError&) {
    throw wrong(text,
                "must be COLUMN:LOW:HIGH:BINS, COLUMN:LOW:HIGH:BINS:log with LOW > 0, or "
                "COLUMN:EDGE,EDGE,...");
  }
}

}  // namespace

BinsRequest parse_bins(std::string_view text, const std::vector<Quantity>& columns,
                       const std::optional<SweepUnits>& units) {
  constexpr std::int64_t most_bins = 100'000;  // each thread has its own
  const std::size_t colon = std::min(text.find(':'), text.size());
  BinsRequest result{column_of(text, text.substr(0, colon), columns, units), {}};
  const Axis edges = edges_of(text, text.substr(std::min(colon + 1, text.size())));
  if (edges.size() < 2 || edges.size() > most_bins + 1) {
    throw wrong(text, fmt::format("must have 1 to {} bins", most_bins));
  }
  result.edges.reserve(static_cast<std::size_t>(edges.size()));
  for (std::int64_t i = 0; i < edges.size(); ++i) {
    result.edges.push_back(edges[i]);
  }
  if (std::ranges::adjacent_find(result.edges, std::greater_equal()) != result.edges.end()) {
    throw wrong(text, "must have increasing edges");
  }
  return result;
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
