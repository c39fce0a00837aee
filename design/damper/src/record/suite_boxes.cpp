// SPDX-License-Identifier: MIT
#include "record/suite_boxes.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <utility>

namespace stillpoint::design {

namespace {

/// Dampers between two checks of whether to go on.
constexpr std::int64_t grid_block = 1024;
/// Of a value that cannot be off: figures vary over some five per cent of the period.
constexpr double period_step = 0.05;
constexpr std::int64_t most_exact_points = 24;
/// Of a grid that is never computed in full: it is kept in memory.
constexpr double most_points = 1e6;
/// Steps to a box at least, by the number of variables, and more of them if a step were longer.
constexpr std::array<std::int64_t, most_axes + 1> least_windows{1, 32, 4, 4, 2, 2, 2};
constexpr double longest_step = 0.06;
/// Two designs are different ones if they are farther apart than a box, or than so many steps.
constexpr std::int64_t least_steps_apart = 2;

GridSide side_of(const SuiteAxis& axis, double step, std::int64_t window) {
  GridSide side;
  side.window = window;
  side.step = step;
  side.lead = window > 0 ? axis.down() : 0;
  side.first = axis.low() - side.lead;
  const double length = axis.high() - axis.low();
  side.points =
      1 + window + (step > 0 ? static_cast<std::int64_t>(std::floor(length / step + 1e-9)) : 0);
  return side;
}

/// With so many steps to a box; with none in steps of `coarse`.
SuiteGrid grid_of(const SuiteSpace& space, std::int64_t window, double coarse) {
  SuiteGrid grid;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const SuiteAxis& axis = space.axes()[i];
    const double length = axis.high() - axis.low();
    if (!axis.searched()) {
      grid.at(i) = {axis.low(), 0, 1, 0, 0};
    } else if (window > 0 && axis.toleranced()) {
      grid.at(i) = side_of(axis, (axis.down() + axis.up()) / static_cast<double>(window), window);
    } else if (space.searched() > 1 && axis.variable() == SuiteAxis::Variable::period) {
      const double points =
          std::clamp(std::ceil(length / period_step), 2.0, static_cast<double>(most_exact_points));
      grid.at(i) = side_of(axis, length / points, 0);
    } else {
      grid.at(i) = side_of(axis, std::min(coarse, length / 2), 0);
    }
  }
  return grid;
}

/// Along one axis of an array with these numbers of points, the worst of each window. In place: a
/// line is written where those before it and it itself were read.
void slide(GridFigures& figures, std::size_t inner, std::size_t points, std::size_t window) {
  if (window == 0) {
    return;
  }
  const std::size_t boxes = points - window;
  const std::size_t stretch = window + 1;
  const std::size_t outer = figures.size() / (inner * points);
  // The worst from each point to the end of its stretch, and from its beginning.
  GridFigures to_end(points, figures.cases());
  GridFigures from_begin(points, figures.cases());
  for (std::size_t o = 0; o < outer; ++o) {
    for (std::size_t i = 0; i < inner; ++i) {
      for (std::size_t k = 0; k < points; ++k) {
        const EachFigures here = std::as_const(figures)[(o * points + k) * inner + i];
        to_end.set(k, here);
        from_begin.set(k, here);
        if (k % stretch != 0) {
          worsen(from_begin[k], std::as_const(from_begin)[k - 1]);
        }
      }
      for (std::size_t k = points - 1; k-- > 0;) {
        if ((k + 1) % stretch != 0) {
          worsen(to_end[k], std::as_const(to_end)[k + 1]);
        }
      }
      for (std::size_t k = 0; k < boxes; ++k) {
        const std::size_t box = (o * boxes + k) * inner + i;
        figures.set(box, to_end[k]);
        worsen(figures[box], std::as_const(from_begin)[k + window]);
      }
    }
  }
  figures.resize(outer * boxes * inner);
}

}  // namespace

double points_of(const SuiteGrid& grid) {
  double all = 1;
  for (const GridSide& side : grid) {
    all *= static_cast<double>(side.points);
  }
  return all;
}

SuiteGrid finest_grid(const SuiteSpace& space) {
  std::int64_t window = space.toleranced() > 0 ? least_windows.at(space.searched()) : 0;
  for (const SuiteAxis& axis : space.axes()) {
    while (window > 0 && axis.searched() &&
           axis.down() + axis.up() > longest_step * static_cast<double>(window)) {
      window *= 2;
    }
  }
  for (; window > 0; window /= 2) {
    const SuiteGrid grid = grid_of(space, window, 0.1);
    if (points_of(grid) <= most_points) {
      return grid;
    }
  }
  double step = 1e-3;
  while (points_of(grid_of(space, 0, step)) > most_points / 4) {
    step *= 2;
  }
  return grid_of(space, 0, step);
}

std::int64_t window_of(const SuiteGrid& grid) {
  return std::ranges::max(grid, {}, &GridSide::window).window;
}

SuiteGrid grid_about(const SuiteSpace& space, const SuiteGrid& like, const SuiteDamper& damper,
                     std::int64_t reach) {
  SuiteGrid grid = like;
  const SuitePlace logs = space.place(damper);
  for (std::size_t i = 0; i < space.size(); ++i) {
    GridSide& side = grid.at(i);
    const std::int64_t steps = space.axes()[i].searched() ? reach : 0;
    side.lead = side.window > 0 ? space.axes()[i].down() : 0;
    side.first = logs.at(i) - side.lead - side.step * static_cast<double>(steps);
    side.points = 1 + side.window + 2 * steps;
  }
  return grid;
}

SuiteGrid finer(const SuiteSpace& space, const SuiteGrid& grid, std::int64_t most) {
  SuiteGrid fine = grid;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const SuiteAxis& axis = space.axes()[i];
    const double box = axis.down() + axis.up();
    GridSide& side = fine.at(i);
    if (!axis.searched()) {
      constexpr std::int64_t window_of_fixed = 2;
      side.window = axis.toleranced() ? window_of_fixed : 0;
      side.step = side.window > 0 ? box / static_cast<double>(side.window) : 0;
      continue;
    }
    const double step = side.step / 2;
    side.window = std::min(
        most, axis.toleranced() ? static_cast<std::int64_t>(std::floor(box / step + 1e-9)) : 0);
    side.step = side.window > 0 ? box / static_cast<double>(side.window) : step;
  }
  return fine;
}

void GridFigures::set(std::size_t point, EachFigures figures) {
  std::ranges::copy(figures, (*this)[point].begin());
}

GridFigures grid_figures(const Suites& suite, const SuiteSpace& space, const SuiteGrid& grid,
                         const Threads& threads, SuiteWatch& watch) {
  const auto count = static_cast<std::int64_t>(points_of(grid));
  GridFigures all(static_cast<std::size_t>(count), suite.cases().size());
  std::vector<SuiteDamper> block;
  for (std::int64_t begin = 0; begin < count && !watch.stopped(); begin += grid_block) {
    block.clear();
    for (std::int64_t index = begin; index < std::min(begin + grid_block, count); ++index) {
      SuitePlace logs{};
      std::int64_t left = index;
      for (std::size_t i = space.size(); i > 0; --i) {
        const GridSide& side = grid.at(i - 1);
        logs.at(i - 1) = side.first + static_cast<double>(left % side.points) * side.step;
        left /= side.points;
      }
      block.push_back(space.at(logs));
    }
    const std::vector<TaskFigures> figures = suite.figures(block, threads);
    for (std::size_t k = 0; k < figures.size(); ++k) {
      all.set(static_cast<std::size_t>(begin) + k, figures[k]);
    }
    watch.evaluated(std::ssize(block));
  }
  return all;
}

bool are_near(const SuitePlace& one, const SuitePlace& other, const SuiteGrid& grid, double part) {
  for (std::size_t i = 0; i < most_axes; ++i) {
    const GridSide& side = grid.at(i);
    const auto box = static_cast<double>(std::max(side.window, least_steps_apart));
    if (std::abs(one.at(i) - other.at(i)) > side.step * (part * box + 0.5)) {
      return false;
    }
  }
  return true;
}

BoxMap::BoxMap(const SuiteSpace& space, const SuiteGrid& grid, GridFigures figures)
    : space_(space), grid_(grid), worst_(std::move(figures)) {
  std::size_t inner = 1;
  for (std::size_t i = space.size(); i > 0; --i) {
    const GridSide& side = grid.at(i - 1);
    slide(worst_, inner, static_cast<std::size_t>(side.points),
          static_cast<std::size_t>(side.window));
    inner *= static_cast<std::size_t>(side.boxes());
  }
}

SuitePlace BoxMap::logs(std::size_t box) const {
  SuitePlace place{};
  for (std::size_t i = space_.size(); i > 0; --i) {
    const GridSide& side = grid_.at(i - 1);
    const auto boxes = static_cast<std::size_t>(side.boxes());
    place.at(i - 1) = side.first + static_cast<double>(box % boxes) * side.step + side.lead;
    box /= boxes;
  }
  return place;
}

std::int64_t BoxMap::admissible(const SuiteGoal& goal) const {
  std::int64_t count = 0;
  for (std::size_t box = 0; box < worst_.size(); ++box) {
    count += design::admissible(worst_[box], goal.limits) ? 1 : 0;
  }
  return count;
}

/// How many steps a box is from another rank, of all axes together: up to a few on each.
std::size_t BoxMap::depth(const std::vector<SuiteRank>& ranks, std::size_t box) const {
  constexpr std::size_t most = 2;
  std::size_t all = 0;
  std::size_t stride = 1;
  for (std::size_t i = space_.size(); i > 0; --i) {
    const auto boxes = static_cast<std::size_t>(grid_.at(i - 1).boxes());
    const std::size_t at = box / stride % boxes;
    for (std::size_t k = 1; k <= most; ++k) {
      const bool same = k <= at && at + k < boxes && ranks[box - k * stride] == ranks[box] &&
                        ranks[box + k * stride] == ranks[box];
      if (!same) {
        break;
      }
      ++all;
    }
    stride *= boxes;
  }
  return all;
}

std::vector<BoxedDamper> BoxMap::best(const SuiteGoal& goal, std::size_t most, double part) const {
  struct Ranked {
    SuiteRank rank;
    std::size_t shallow;  // of equal ones the deepest: at its rim a plateau is not sure
    std::size_t box;
    auto operator<=>(const Ranked&) const = default;
  };
  std::vector<SuiteRank> ranks;
  ranks.reserve(worst_.size());
  for (std::size_t box = 0; box < worst_.size(); ++box) {
    ranks.push_back(rank(worst_[box], goal));
  }
  std::vector<Ranked> left;  // a heap, for few of them are looked at
  left.reserve(worst_.size());
  for (std::size_t box = 0; box < worst_.size(); ++box) {
    left.push_back({ranks[box], 2 * most_axes - depth(ranks, box), box});
  }
  std::ranges::make_heap(left, std::greater());
  std::vector<BoxedDamper> list;
  std::vector<SuitePlace> places;
  for (; !left.empty() && list.size() < most; left.pop_back()) {
    std::ranges::pop_heap(left, std::greater());
    const auto& [of_box, shallow, box] = left.back();
    const SuitePlace here = logs(box);
    if (space_.includes(here) && std::ranges::none_of(places, [&](const SuitePlace& other) {
          return are_near(here, other, grid_, part);
        })) {
      places.push_back(here);
      const EachFigures worst = worst_[box];
      list.push_back({space_.at(here), {worst.begin(), worst.end()}, of_box});
    }
  }
  return list;
}

}  // namespace stillpoint::design
