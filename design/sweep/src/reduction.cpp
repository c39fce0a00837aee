// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/reduction.hpp>

#include <algorithm>
#include <functional>
#include <utility>

namespace stillpoint::sweep {

namespace {

/// Whether (value, entry) is more extreme; of the same values the first one is.
bool beats(double value, std::int64_t entry, double other, std::int64_t other_entry, bool most) {
  if (value != other) {
    return most ? value > other : value < other;
  }
  return entry < other_entry;
}

void keep_extreme(std::optional<ReducedRow>& kept, const std::optional<ReducedRow>& other,
                  std::size_t column, bool most) {
  if (other && (!kept || beats(other->values[column], other->entry, kept->values[column],
                               kept->entry, most))) {
    kept = other;
  }
}

}  // namespace

bool BestRows::better(const ReducedRow& one, const ReducedRow& other) const {
  return beats(one.values[column_], one.entry, other.values[column_], other.entry, largest_);
}

std::vector<ReducedRow> BestRows::rows() const {
  std::vector<ReducedRow> sorted = heap_;
  std::ranges::sort(sorted, std::bind_front(&BestRows::better, this));
  return sorted;
}

bool BestRows::takes(double value, std::int64_t entry) const {
  return heap_.size() < most_ ||
         beats(value, entry, heap_.front().values[column_], heap_.front().entry, largest_);
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
    keep_extreme(column.least, other.least, column.column, false);
    keep_extreme(column.largest, other.largest, column.column, true);
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
