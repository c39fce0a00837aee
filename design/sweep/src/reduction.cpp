// SPDX-License-Identifier: MIT
#include <stillpoint/sweep/reduction.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace stillpoint::sweep {

namespace {

constexpr unsigned dropped_bits = 49;  // of a double; sign, exponent and three bits are left
constexpr std::size_t negative = std::size_t{1} << 14U;

std::size_t fine_bin(double value) {
  const auto bin = static_cast<std::size_t>(std::bit_cast<std::uint64_t>(value) >> dropped_bits);
  return bin == negative ? 0 : bin;  // with -0
}

/// The end of a bin that is nearer to 0.
double inner_end(std::size_t bin) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(bin) << dropped_bits);
}

/// The other end; the last bin ends with the largest double.
double outer_end(std::size_t bin) {
  const double end = inner_end(bin + 1);
  return std::isfinite(end) ? end : std::copysign(std::numeric_limits<double>::max(), end);
}

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

void FineBins::add(double value, std::int64_t times) {
  counts_[fine_bin(value)] += times;
}

void FineBins::add(const FineBins& other) {
  std::ranges::transform(counts_, other.counts_, counts_.begin(), std::plus());
}

std::vector<FineBins::Bin> FineBins::filled() const {
  std::vector<Bin> bins;
  for (std::size_t bin = count; bin-- > negative;) {
    if (counts_[bin] > 0) {
      bins.push_back({outer_end(bin), inner_end(bin), counts_[bin]});
    }
  }
  if (counts_[0] > 0) {
    bins.push_back({0, 0, counts_[0]});
  }
  for (std::size_t bin = 1; bin < negative; ++bin) {
    if (counts_[bin] > 0) {
      bins.push_back({inner_end(bin), outer_end(bin), counts_[bin]});
    }
  }
  return bins;
}

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
    column.bins.add(other.bins);
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

std::optional<Interval> quantile(const Reduction& reduction, const ReducedColumn& column,
                                 double share) {
  if (column.count == 0) {
    return std::nullopt;
  }
  const auto rank = std::max<std::int64_t>(
      1, static_cast<std::int64_t>(std::ceil(share * static_cast<double>(column.count))));
  double low = column.least->values[column.column];
  double high = column.largest->values[column.column];
  const auto narrow = [&](double from, double to) {
    low = std::max(low, from);
    high = std::min(high, to);
  };
  std::int64_t before = 0;
  for (const FineBins::Bin& bin : column.bins.filled()) {
    if (before < rank && rank <= before + bin.count) {
      narrow(bin.low, bin.high);
    }
    before += bin.count;
  }
  for (const Histogram& histogram : reduction.histograms) {
    if (histogram.column != column.column) {
      continue;
    }
    before = histogram.below;
    for (std::size_t i = 0; i < histogram.counts.size(); before += histogram.counts[i], ++i) {
      if (before < rank && rank <= before + histogram.counts[i]) {
        narrow(histogram.edges[i], histogram.edges[i + 1]);
      }
    }
  }
  return Interval{low, high};
}

}  // namespace stillpoint::sweep
