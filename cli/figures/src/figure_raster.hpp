// SPDX-License-Identifier: MIT
#pragma once

#include <stillpoint/figures/figure.hpp>

namespace stillpoint::figures {

/// In pixels of the plot, y down.
struct Box {
  double left;
  double top;
  double right;
  double bottom;

  [[nodiscard]] Box grown(double by) const {
    return {left - by, top - by, right + by, bottom + by};
  }
};

[[nodiscard]] inline Box box_around(const FigurePoint& centre, double width, double height) {
  return {centre.x - width / 2, centre.y - height / 2, centre.x + width / 2, centre.y + height / 2};
}

/// Which cells of the plot are set, a few pixels each, and how many of them in a box.
class Raster {
 public:
  static constexpr double cell = 3;  // pixels

  Raster(double width, double height);

  /// All that the box touches.
  void set(const Box& box, bool value = true);
  /// Along the straight lines between points.
  void set_line(const Points& points);
  /// Inside the polygon, where none is set yet.
  void fill(const Points& outline);
  /// Calls is_set(middle of the cell) for each.
  template <class IsSet>
  void set_where(const IsSet& is_set) {
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (is_set(FigurePoint{middle(i % columns_), middle(i / columns_)})) {
        cells_[i] = 1;
      }
    }
    sums_.clear();
  }

  /// Of the cells that the box touches within the plot: how many are set, whether all are.
  [[nodiscard]] int set_in(const Box& box) const;
  [[nodiscard]] bool is_full(const Box& box) const;
  /// Around all that are set.
  [[nodiscard]] Box extent() const;

 private:
  /// Columns or rows.
  struct Range {
    std::size_t first;
    std::size_t last;  ///< one beyond
  };
  [[nodiscard]] static Range range(double from, double to, std::size_t most);
  [[nodiscard]] Range across(const Box& box) const { return range(box.left, box.right, columns_); }
  [[nodiscard]] Range down(const Box& box) const { return range(box.top, box.bottom, rows_); }
  [[nodiscard]] static double middle(std::size_t index) {
    return (static_cast<double>(index) + 0.5) * cell;
  }
  void sum() const;

  std::size_t columns_;
  std::size_t rows_;
  std::vector<int> cells_;
  mutable std::vector<int> sums_;  ///< of the cells above and to the left; empty: not yet
};

}  // namespace stillpoint::figures
