// SPDX-License-Identifier: MIT
#include "figure_raster.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::figures {

Raster::Raster(double width, double height)
    : columns_(static_cast<std::size_t>(width / cell)),
      rows_(static_cast<std::size_t>(height / cell)),
      cells_(columns_ * rows_, 0) {}

Raster::Range Raster::range(double from, double to, std::size_t most) {
  const auto within = [&](double at) {
    return std::clamp(at / cell, 0.0, static_cast<double>(most));
  };
  return {static_cast<std::size_t>(within(from)), static_cast<std::size_t>(std::ceil(within(to)))};
}

void Raster::write(const Box& box, int value) {
  const Range across = columns(box.left, box.right);
  const Range down = rows(box.top, box.bottom);
  for (std::size_t row = down.first; row < down.last; ++row) {
    for (std::size_t column = across.first; column < across.last; ++column) {
      cells_[row * columns_ + column] = value;
    }
  }
  summed_ = false;
}

void Raster::set(const FigurePoint& at) {
  set(Box{at.x, at.y, at.x, at.y + 1e-9});
  set(Box{at.x, at.y, at.x + 1e-9, at.y + 1e-9});
}

void Raster::set_line(const std::vector<FigurePoint>& points) {
  constexpr double most_steps = 2000;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const FigurePoint& a = points[i - 1];
    const FigurePoint& b = points[i];
    const double steps =
        std::min(most_steps, std::ceil(std::hypot(b.x - a.x, b.y - a.y) / cell) + 1);
    for (double done = 0; done <= steps; ++done) {
      set(FigurePoint{a.x + (b.x - a.x) * done / steps, a.y + (b.y - a.y) * done / steps});
    }
  }
}

void Raster::fill(const std::vector<FigurePoint>& outline) {
  std::vector<std::vector<double>> crossings(rows_);
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const FigurePoint& a = outline[i];
    const FigurePoint& b = outline[(i + 1) % outline.size()];
    const Range down = rows(std::min(a.y, b.y), std::max(a.y, b.y));
    for (std::size_t row = down.first; row < down.last; ++row) {
      const double y = middle(row);
      if ((a.y <= y) != (b.y <= y)) {
        crossings[row].push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
  }
  for (std::size_t row = 0; row < rows_; ++row) {
    std::ranges::sort(crossings[row]);
    for (std::size_t i = 1; i < crossings[row].size(); i += 2) {
      const double from = crossings[row][i - 1];
      const double to = crossings[row][i];
      const Range across = columns(from, to);
      for (std::size_t column = across.first; column < across.last; ++column) {
        if (from <= middle(column) && middle(column) < to) {
          cells_[row * columns_ + column] = 1;
        }
      }
    }
  }
  summed_ = false;
}

void Raster::sum() const {
  const std::size_t wide = columns_ + 1;
  sums_.assign(wide * (rows_ + 1), 0);
  for (std::size_t row = 0; row < rows_; ++row) {
    int in_row = 0;
    for (std::size_t column = 0; column < columns_; ++column) {
      in_row += cells_[row * columns_ + column];
      sums_[(row + 1) * wide + column + 1] = sums_[row * wide + column + 1] + in_row;
    }
  }
  summed_ = true;
}

}  // namespace stillpoint::figures
