// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

#include <cstddef>
#include <vector>

namespace stillpoint::figures {

/// In pixels of the plot, y down.
struct Box {
  double left;
  double top;
  double right;
  double bottom;
};

/// Which cells of the plot are set, a few pixels each, and how many of them in a box.
class Raster {
 public:
  static constexpr double cell = 3;  // pixels

  Raster(double width, double height);

  void set(const FigurePoint& at);
  void set(const Box& box) { write(box, 1); }
  void clear(const Box& box) { write(box, 0); }
  /// Along the straight lines between points.
  void set_line(const std::vector<FigurePoint>& points);
  /// Inside the polygon.
  void fill(const std::vector<FigurePoint>& outline);
  /// Calls is_set(middle of the cell) for each.
  template <class IsSet>
  void set_where(const IsSet& is_set) {
    for (std::size_t row = 0; row < rows_; ++row) {
      for (std::size_t column = 0; column < columns_; ++column) {
        if (is_set(FigurePoint{middle(column), middle(row)})) {
          cells_[row * columns_ + column] = 1;
        }
      }
    }
    summed_ = false;
  }

  /// Columns or rows.
  struct Range {
    std::size_t first;
    std::size_t last;  ///< one beyond
    [[nodiscard]] std::size_t size() const { return last - first; }
  };
  /// Those that the pixels from `from` to `to` touch within the plot.
  [[nodiscard]] Range columns(double from, double to) const { return range(from, to, columns_); }
  [[nodiscard]] Range rows(double from, double to) const { return range(from, to, rows_); }

  /// Of the cells of these columns and rows: how many are set, whether all are.
  [[nodiscard]] int set_in(const Range& columns, const Range& rows) const {
    if (!summed_) {
      sum();
    }
    const int* const upper = &sums_[rows.first * (columns_ + 1)];
    const int* const lower = &sums_[rows.last * (columns_ + 1)];
    return lower[columns.last] - upper[columns.last] - lower[columns.first] + upper[columns.first];
  }
  [[nodiscard]] bool is_full(const Range& columns, const Range& rows) const {
    return set_in(columns, rows) == static_cast<int>(columns.size() * rows.size());
  }
  /// The same of the cells that the box touches.
  [[nodiscard]] int set_in(const Box& box) const {
    return set_in(columns(box.left, box.right), rows(box.top, box.bottom));
  }
  [[nodiscard]] bool is_full(const Box& box) const {
    return is_full(columns(box.left, box.right), rows(box.top, box.bottom));
  }

 private:
  void write(const Box& box, int value);
  [[nodiscard]] static Range range(double from, double to, std::size_t most);
  [[nodiscard]] static double middle(std::size_t index) {
    return (static_cast<double>(index) + 0.5) * cell;
  }
  void sum() const;

  std::size_t columns_;
  std::size_t rows_;
  std::vector<int> cells_;
  mutable std::vector<int> sums_;  ///< of the cells above and to the left
  mutable bool summed_{false};
};

}  // namespace stillpoint::figures
