// SPDX-License-Identifier: MIT
#include "record/suite_scan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace stillpoint::design {

namespace {

/// Of a value, between two points of the first look.
constexpr double first_step = 0.21;

/// Whether a design as far off as `part` of each value may be within the limits and better than
/// `bar`: a figure other than a residual or a jump changes by hardly more than its damper does.
bool promising(EachFigures figures, const SuiteGoal& goal, double bar, double part) {
  const auto is_smooth = [](double SuiteFigures::*figure) {
    return figure == &SuiteFigures::peak || figure == &SuiteFigures::acceleration;
  };
  if (!settled(figures)) {
    return false;
  }
  for (std::size_t i = 0; i < figures.size(); ++i) {
    for (const SuiteFigureKind& kind : suite_figure_kinds) {
      const std::optional<double>& limit = goal.limits[i].*kind.limit;
      if (is_smooth(kind.value) && limit && figures[i].*kind.value > *limit * (1 + part)) {
        return false;
      }
    }
  }
  return goal.figure == nullptr || !is_smooth(goal.figure) ||
         goal.value(figures) < bar * (1 + part);
}

}  // namespace

std::int64_t points_of_scan(const RecordDesignRequest& task, const SuiteSpace& space,
                            std::int64_t of_a_line) {
  constexpr std::int64_t times_of_three = 4;
  const std::size_t searched = space.searched();
  return searched <= 1   ? std::min(of_a_line, task.scan_points)
         : searched == 2 ? task.scan_points
                         : times_of_three * task.scan_points;
}

SuiteScan::SuiteScan(const Suites& suite, const SuiteSpace& space, std::int64_t points,
                     const Threads& threads, SuiteWatch& watch)
    : suite_(suite),
      space_(space),
      points_(points),
      threads_(threads),
      watch_(watch),
      finest_(finest_grid(space)) {
  const double step = longest_step();
  const auto is_small = [&](std::int64_t stride) {
    return 2 * static_cast<double>(stride) * step <= first_step ||
           (window_of(finest_) == 0 && points_of_stride(stride) > points_);
  };
  while (step > 0 && is_small(first_stride_)) {
    first_stride_ *= 2;
  }
  row_.resize(static_cast<std::size_t>(points_of(finest_)), -1);
}

double SuiteScan::longest_step() const {
  return std::ranges::max(finest_, {}, &GridSide::step).step;
}

std::size_t SuiteScan::flat(const Index& index) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < most_axes; ++i) {
    at =
        at * static_cast<std::size_t>(finest_.at(i).points) + static_cast<std::size_t>(index.at(i));
  }
  return at;
}

std::int64_t SuiteScan::points_of_stride(std::int64_t stride) const {
  std::int64_t all = 1;
  for (const GridSide& side : finest_) {
    all *= 1 + (side.points + stride - 2) / stride;
  }
  return all;
}

/// The last along each axis among them.
std::vector<SuiteScan::Index> SuiteScan::of_stride(std::int64_t stride) const {
  std::vector<Index> list{Index{}};
  for (std::size_t i = 0; i < most_axes; ++i) {
    const std::int64_t last = finest_.at(i).points - 1;
    std::vector<Index> longer;
    for (Index index : list) {
      for (std::int64_t k = 0; k <= last; k = k < last ? std::min(k + stride, last) : last + 1) {
        index.at(i) = k;
        longer.push_back(index);
      }
    }
    list = std::move(longer);
  }
  return list;
}

/// At a corner of the cell of twice the stride.
bool SuiteScan::has_promising_neighbour(const Index& index, std::int64_t stride,
                                        const SuiteGoal& goal, double bar) const {
  std::vector<Index> corners{index};
  double part = 0;
  for (std::size_t i = 0; i < most_axes; ++i) {
    const GridSide& side = finest_.at(i);
    part = std::max(part, static_cast<double>(stride) * side.step / 2);
    const std::int64_t below = index.at(i) / (2 * stride) * (2 * stride);
    const std::int64_t above = std::min(below + 2 * stride, side.points - 1);
    if (index.at(i) == below || index.at(i) == above) {
      continue;
    }
    const std::size_t count = corners.size();
    for (std::size_t k = 0; k < count; ++k) {
      corners.push_back(corners[k]);
      corners[k].at(i) = below;
      corners.back().at(i) = above;
    }
  }
  return std::ranges::any_of(corners, [&](const Index& corner) {
    const TaskFigures* const figures = known(corner);
    return figures != nullptr && promising(*figures, goal, bar, part);
  });
}

const TaskFigures* SuiteScan::known(const Index& index) const {
  const std::int64_t row = row_[flat(index)];
  return row < 0 ? nullptr : &figures_[static_cast<std::size_t>(row)];
}

SuitePlace SuiteScan::place(const Index& index) const {
  SuitePlace logs{};
  for (std::size_t i = 0; i < space_.size(); ++i) {
    const GridSide& side = finest_.at(i);
    logs.at(i) = side.first + static_cast<double>(index.at(i)) * side.step;
  }
  return logs;
}

void SuiteScan::compute(const std::vector<Index>& list) {
  constexpr std::size_t block = 1024;  // between two checks of whether to go on
  for (std::size_t begin = 0; begin < list.size() && !watch_.stopped(); begin += block) {
    const std::size_t end = std::min(begin + block, list.size());
    std::vector<SuiteDamper> dampers;
    for (std::size_t k = begin; k < end; ++k) {
      dampers.push_back(space_.at(place(list[k])));
    }
    for (std::size_t k = begin; k < end; ++k) {
      row_[flat(list[k])] = std::ssize(figures_) + static_cast<std::int64_t>(k - begin);
    }
    std::ranges::move(suite_.figures(dampers, threads_), std::back_inserter(figures_));
    watch_.evaluated(std::ssize(dampers));
  }
}

void SuiteScan::look(const SuiteGoal& goal, double bar) {
  stride_ = first_stride_;
  std::int64_t used = 0;
  for (std::int64_t stride = first_stride_; stride > 0 && !watch_.stopped(); stride /= 2) {
    std::vector<Index> list = of_stride(stride);
    std::erase_if(list, [&](const Index& index) {
      return known(index) != nullptr ||
             (stride < first_stride_ && !has_promising_neighbour(index, stride, goal, bar));
    });
    used += std::ssize(list);
    if (used > points_ && stride < first_stride_ && 2 * stride <= window_of(finest_)) {
      break;
    }
    compute(list);
    stride_ = stride;
  }
}

bool SuiteScan::may_have(const SuiteGoal& goal) const {
  const double part = static_cast<double>(stride_) * longest_step();
  return std::ranges::any_of(figures_, [&](const TaskFigures& figures) {
    return promising(figures, goal, HUGE_VAL, part);
  });
}

std::optional<SuiteDamper> SuiteScan::nearest(const SuiteGoal& goal) const {
  SuitePlace best{};
  std::optional<SuiteRank> least;
  for (const Index& index : of_stride(1)) {
    const TaskFigures* const figures = known(index);
    if (figures != nullptr && (!least || rank(*figures, goal) < *least)) {
      least = rank(*figures, goal);
      best = place(index);
    }
  }
  if (!least) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < space_.size(); ++i) {
    best.at(i) = std::clamp(best.at(i), space_.axes()[i].low(), space_.axes()[i].high());
  }
  return space_.at(best);
}

SuiteGrid SuiteScan::grid() const {
  SuiteGrid grid = finest_;
  for (GridSide& side : grid) {
    side.window /= stride_;
    side.step *= static_cast<double>(stride_);
    side.points = 1 + (side.points - 1) / stride_;
  }
  return grid;
}

/// Of the points of that grid.
GridFigures SuiteScan::figures() const {
  GridFigures list(static_cast<std::size_t>(points_of(grid())), suite_.cases().size());
  std::size_t point = 0;
  for (const Index& index : of_stride(stride_)) {
    if (std::ranges::all_of(index, [&](std::int64_t k) { return k % stride_ == 0; })) {
      if (const TaskFigures* const figures = known(index)) {
        list.set(point, *figures);
      }
      ++point;
    }
  }
  return list;
}

}  // namespace stillpoint::design
