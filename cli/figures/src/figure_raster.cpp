// SPDX-License-Identifier: MIT
#include "figure_raster.hpp"

#include <algorithm>
#include <cmath>

namespace stillpoint::figures {

Raster::Raster(double width, double height)
    : columns_(static_cast<std::size_t>(width / cell)),
      rows_(static_cast<std::size_t>(height / cell)),
      cells_(columns_ * rows_, 0) {}

Raster::Range Raster::range(const Box& box) const {
  const auto within = [](double at, std::size_t most) {
    return std::clamp(at / cell, 0.0, static_cast<double>(most));
  };
  const auto down = [&](double at, std::size_t most) {
    return static_cast<std::size_t>(within(at, most));
  };
  const auto up = [&](double at, std::size_t most) {
    return static_cast<std::size_t>(std::ceil(within(at, most)));
  };
  return {down(box.left, columns_), up(box.right, columns_), down(box.top, rows_),
          up(box.bottom, rows_)};
}

void Raster::set(const Box& box) {
  const auto [first_column, last_column, first_row, last_row] = range(box);
  for (std::size_t row = first_row; row < last_row; ++row) {
    for (std::size_t column = first_column; column < last_column; ++column) {
      cells_[row * columns_ + column] = 1;
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
  for (std::size_t row = 0; row < rows_; ++row) {
    const double y = middle(row);
    std::vector<double> crossings;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const FigurePoint& a = outline[i];
      const FigurePoint& b = outline[(i + 1) % outline.size()];
      if ((a.y <= y) != (b.y <= y)) {
        crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
    std::ranges::sort(crossings);
    for (std::size_t i = 1; i < crossings.size(); i += 2) {
      for (std::size_t column = 0; column < columns_; ++column) {
        if (crossings[i - 1] <= middle(column) && middle(column) < crossings[i]) {
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
    for (std::size_t column = 0; column < columns_; ++column) {
      sums_[(row + 1) * wide + column + 1] =
          cells_[row * columns_ + column] + sums_[row * wide + column + 1] +
          sums_[(row + 1) * wide + column] - sums_[row * wide + column];
    }
  }
  summed_ = true;
}

int Raster::set_in(const Range& range) const {
  if (!summed_) {
    sum();
  }
  const auto& [first_column, last_column, first_row, last_row] = range;
  const std::size_t wide = columns_ + 1;
  return sums_[last_row * wide + last_column] - sums_[first_row * wide + last_column] -
         sums_[last_row * wide + first_column] + sums_[first_row * wide + first_column];
}

int Raster::set_in(const Box& box) const {
  return set_in(range(box));
}

bool Raster::is_full(const Box& box) const {
  const Range cells = range(box);
  return set_in(cells) == static_cast<int>((cells.last_column - cells.first_column) *
                                           (cells.last_row - cells.first_row));
}

}  // namespace stillpoint::figures
