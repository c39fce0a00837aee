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
  const double end = within(to);
  const auto last = static_cast<std::size_t>(end);
  return {static_cast<std::size_t>(within(from)),
          static_cast<double>(last) < end ? last + 1 : last};
}

void Raster::set(const Box& box, bool value) {
  const auto [left, right] = across(box);
  const auto [top, bottom] = down(box);
  for (std::size_t row = top; row < bottom; ++row) {
    std::fill(cells_.begin() + static_cast<std::ptrdiff_t>(row * columns_ + left),
              cells_.begin() + static_cast<std::ptrdiff_t>(row * columns_ + right), value ? 1 : 0);
  }
  sums_.clear();
}

int Raster::set_in(const Box& box) const {
  if (sums_.empty()) {
    sum();
  }
  const auto [left, right] = across(box);
  const int* const upper = &sums_[down(box).first * (columns_ + 1)];
  const int* const lower = &sums_[down(box).last * (columns_ + 1)];
  return lower[right] - upper[right] - lower[left] + upper[left];
}

bool Raster::is_full(const Box& box) const {
  const auto [left, right] = across(box);
  const auto [top, bottom] = down(box);
  return set_in(box) == static_cast<int>((right - left) * (bottom - top));
}

void Raster::set_line(const Points& points) {
  constexpr double most_steps = 2000;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const FigurePoint& a = points[i - 1];
    const FigurePoint& b = points[i];
    const double steps =
        std::min(most_steps, std::ceil(std::hypot(b.x - a.x, b.y - a.y) / cell) + 1);
    for (double done = 0; done <= steps; ++done) {
      const double x = std::lerp(a.x, b.x, done / steps);
      const double y = std::lerp(a.y, b.y, done / steps);
      set({x, y, x + 1e-9, y + 1e-9});
    }
  }
}

void Raster::fill(const Points& outline) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const FigurePoint& a = outline[i];
    const FigurePoint& b = outline[(i + 1) % outline.size()];
    const auto [top, bottom] = range(std::min(a.y, b.y), std::max(a.y, b.y), rows_);
    for (std::size_t row = top; row < bottom; ++row) {
      const double y = middle(row);
      if ((a.y <= y) != (b.y <= y)) {
        // Each edge turns all that is to the right of it: what is inside is turned an odd number of
        // times.
        const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
        for (std::size_t column = 0; column < columns_; ++column) {
          cells_[row * columns_ + column] ^= x <= middle(column) ? 1 : 0;
        }
      }
    }
  }
  sums_.clear();
}

Box Raster::extent() const {
  Box box{HUGE_VAL, HUGE_VAL, 0, 0};
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i] != 0) {
      const std::size_t row = i / columns_;
      const double left = cell * static_cast<double>(i % columns_);
      const double top = cell * static_cast<double>(row);
      box = {std::min(box.left, left), std::min(box.top, top), std::max(box.right, left + cell),
             std::max(box.bottom, top + cell)};
    }
  }
  return box;
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
}

}  // namespace stillpoint::figures
