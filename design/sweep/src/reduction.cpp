// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/reduction.hpp>

#include <algorithm>
#include <stdexcept>

namespace stillpoint::sweep {

bool is_sound(const Reduction& reduction) {
  const auto is_row = [&](const ReducedRow& row) {
    return row.values.empty() ||
           std::ranges::equal(reduction.row, row.values, [](const auto& column, double value) {
             return column.form != Form::outcome || (value >= 0 && value < sweep_outcome_count);
           });
  };
  const std::size_t width = reduction.row.size();
  return std::ranges::all_of(reduction.columns,
                             [&](const ReducedColumn& column) {
                               return column.column < width && is_row(column.least) &&
                                      is_row(column.largest);
                             }) &&
         std::ranges::all_of(reduction.histograms, [width](const Histogram& histogram) {
           return histogram.column < width && histogram.edges.size() == histogram.counts.size() + 1;
         });
}

namespace {

/// Adds each to the one at its place.
template <class Item>
void add_each(std::vector<Item>& totals, const std::vector<Item>& more, const auto& add) {
  if (totals.size() != more.size()) {
    throw std::invalid_argument("reductions of different sweeps");
  }
  for (std::size_t i = 0; i < totals.size(); ++i) {
    add(totals[i], more[i]);
  }
}

/// Keeps the one with the smaller value in a column, or the larger; of equals the first.
void keep(ReducedRow& kept, const ReducedRow& rival, std::size_t column, bool larger) {
  if (kept.values.empty() || rival.values.empty()) {
    kept = kept.values.empty() ? rival : kept;
    return;
  }
  const double value = kept.values[column];
  const double other = rival.values.at(column);
  if (value == other ? rival.entry < kept.entry : (larger ? other > value : other < value)) {
    kept = rival;
  }
}

}  // namespace

void add(Reduction& total, const Reduction& more) {
  add_each(total.columns, more.columns, [](ReducedColumn& column, const ReducedColumn& other) {
    column.count += other.count;
    column.absent += other.absent;
    column.infinite += other.infinite;
    keep(column.least, other.least, column.column, false);
    keep(column.largest, other.largest, column.column, true);
  });
  add_each(total.histograms, more.histograms, [](Histogram& histogram, const Histogram& other) {
    add_each(histogram.counts, other.counts,
             [](std::int64_t& count, std::int64_t more_of_it) { count += more_of_it; });
    histogram.below += other.below;
    histogram.above += other.above;
  });
}

}  // namespace stillpoint::sweep
