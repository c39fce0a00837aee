// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/reduction.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

namespace stillpoint::sweep {

bool BestRows::better(const ReducedRow& one, const ReducedRow& other) const {
  const double value = one.values[column];
  const double rival = other.values[column];
  return value != rival ? (largest ? value > rival : value < rival) : one.entry < other.entry;
}

std::vector<ReducedRow> BestRows::rows() const {
  std::vector<ReducedRow> sorted = heap;
  std::ranges::sort(sorted, std::bind_front(&BestRows::better, this));
  return sorted;
}

double BestRows::bar() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return heap.size() == most ? heap.front().values[column] : largest ? -infinite : infinite;
}

void BestRows::add(ReducedRow row) {
  const auto order = std::bind_front(&BestRows::better, this);
  heap.push_back(std::move(row));
  std::ranges::push_heap(heap, order);
  if (heap.size() > most) {
    std::ranges::pop_heap(heap, order);
    heap.pop_back();
  }
}

void BestRows::add(const BestRows& other) {
  for (const ReducedRow& row : other.heap) {
    if (std::isfinite(row.values.at(column))) {
      add(row);
    }
  }
}

bool is_sound(const Reduction& reduction) {
  const std::size_t width = reduction.row.size();
  const auto is_row = [&reduction](const ReducedRow& row) {
    return std::ranges::equal(reduction.row, row.values, [](const auto& column, double value) {
      return column.form != Form::outcome || (value >= 0 && value < sweep_outcome_count);
    });
  };
  const auto fits = [&](const BestRows& best) {
    return best.column < width && best.most >= 1 && best.heap.size() <= best.most &&
           std::ranges::all_of(best.heap, is_row);
  };
  const auto is_column = [&](const ReducedColumn& column) {
    return column.column < width && fits(column.least) && fits(column.largest);
  };
  const auto is_histogram = [width](const Histogram& histogram) {
    return histogram.column < width && histogram.edges.size() == histogram.counts.size() + 1;
  };
  return std::ranges::all_of(reduction.columns, is_column) &&
         std::ranges::all_of(reduction.histograms, is_histogram) &&
         std::ranges::all_of(reduction.best, fits);
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

}  // namespace

void add(Reduction& total, const Reduction& more) {
  const auto add_count = [](std::int64_t& count, std::int64_t other) { count += other; };
  add_each(total.columns, more.columns, [](ReducedColumn& column, const ReducedColumn& other) {
    column.count += other.count;
    column.absent += other.absent;
    column.infinite += other.infinite;
    column.least.add(other.least);
    column.largest.add(other.largest);
  });
  add_each(total.histograms, more.histograms, [&](Histogram& histogram, const Histogram& other) {
    add_each(histogram.counts, other.counts, add_count);
    histogram.below += other.below;
    histogram.above += other.above;
  });
  add_each(total.best, more.best, [](BestRows& best, const BestRows& other) { best.add(other); });
}

}  // namespace stillpoint::sweep
