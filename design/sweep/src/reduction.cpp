// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/reduction.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace stillpoint::sweep {

bool BestRows::better(const ReducedRow& one, const ReducedRow& other) const {
  const double value = one.values[column_];
  const double rival = other.values[column_];
  return value != rival ? (largest_ ? value > rival : value < rival) : one.entry < other.entry;
}

std::vector<ReducedRow> BestRows::rows() const {
  std::vector<ReducedRow> sorted = heap_;
  std::ranges::sort(sorted, std::bind_front(&BestRows::better, this));
  return sorted;
}

double BestRows::bar() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return heap_.size() == most_ ? heap_.front().values[column_] : largest_ ? -infinite : infinite;
}

void BestRows::add(ReducedRow row) {
  const auto order = std::bind_front(&BestRows::better, this);
  heap_.push_back(std::move(row));
  std::ranges::push_heap(heap_, order);
  if (heap_.size() > most_) {
    std::ranges::pop_heap(heap_, order);
    heap_.pop_back();
  }
}

void BestRows::add(const BestRows& other) {
  std::ranges::for_each(other.heap_, [this](const ReducedRow& row) { add(row); });
}

void add(Reduction& total, const Reduction& more) {
  for (std::size_t i = 0; i < total.columns.size(); ++i) {
    ReducedColumn& column = total.columns[i];
    const ReducedColumn& other = more.columns[i];
    column.count += other.count;
    column.absent += other.absent;
    column.infinite += other.infinite;
    column.least.add(other.least);
    column.largest.add(other.largest);
  }
  for (std::size_t i = 0; i < total.histograms.size(); ++i) {
    Histogram& histogram = total.histograms[i];
    const Histogram& other = more.histograms[i];
    std::ranges::transform(histogram.counts, other.counts, histogram.counts.begin(), std::plus());
    histogram.below += other.below;
    histogram.above += other.above;
  }
  for (std::size_t i = 0; i < total.best.size(); ++i) {
    total.best[i].add(more.best[i]);
  }
}

}  // namespace stillpoint::sweep
