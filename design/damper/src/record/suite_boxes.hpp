// SPDX-License-Identifier: MIT
#pragma once

// Dampers on a grid that is even in the logarithms of their values, so that the box of a tolerance
// is a window of constant size, and the worst over each box is a sliding maximum.

#include "record/suite_space.hpp"
#include "record/suite_watch.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stillpoint::design {

/// A damper with the worst of its box.
struct BoxedDamper {
  SuiteDamper damper;
  TaskFigures worst;
  SuiteRank rank{};
};

/// The grid along an axis. The box i reaches from the point i to the point i + window; its design
/// is at first + i step + lead.
struct GridSide {
  double first{0};
  double step{0};
  std::int64_t points{1};
  std::int64_t window{0};
  double lead{0};

  [[nodiscard]] std::int64_t boxes() const { return points - window; }
};
using SuiteGrid = std::array<GridSide, most_axes>;

/// The whole space with the smallest steps that a scan may use.
[[nodiscard]] SuiteGrid finest_grid(const SuiteSpace& space);

/// How many there are.
[[nodiscard]] double points_of(const SuiteGrid& grid);
/// The most steps to a box.
[[nodiscard]] std::int64_t window_of(const SuiteGrid& grid);

/// About a design: `reach` boxes to each side of it along each axis that is searched, with the
/// steps and windows of `like`.
[[nodiscard]] SuiteGrid grid_about(const SuiteSpace& space, const SuiteGrid& like,
                                   const SuiteDamper& damper, std::int64_t reach);

/// With half the step, or smaller; windows of at most `most`.
[[nodiscard]] SuiteGrid finer(const SuiteSpace& space, const SuiteGrid& grid, std::int64_t most);

/// The figures of all points of a grid, the last axis running fastest. They lie one behind the
/// other: a grid may have a million points.
class GridFigures {
 public:
  GridFigures() = default;
  /// Unsettled all.
  GridFigures(std::size_t points, std::size_t cases)
      : cases_(cases), all_(points * cases, unsettled) {}

  [[nodiscard]] std::size_t size() const { return all_.size() / cases_; }
  [[nodiscard]] std::size_t cases() const { return cases_; }
  [[nodiscard]] EachFigures operator[](std::size_t point) const {
    return EachFigures(all_).subspan(point * cases_, cases_);
  }
  [[nodiscard]] std::span<SuiteFigures> operator[](std::size_t point) {
    return std::span(all_).subspan(point * cases_, cases_);
  }
  void set(std::size_t point, EachFigures figures);
  void resize(std::size_t points) { all_.resize(points * cases_); }

 private:
  std::size_t cases_{1};
  std::vector<SuiteFigures> all_;
};

/// Of the whole grid; after a stop the rest is unsettled.
[[nodiscard]] GridFigures grid_figures(const Suites& suite, const SuiteSpace& space,
                                       const SuiteGrid& grid, const Threads& threads,
                                       SuiteWatch& watch);

/// Whether two designs are closer than that part of a box along every axis.
[[nodiscard]] bool are_near(const SuitePlace& one, const SuitePlace& other, const SuiteGrid& grid,
                            double part = 1);

/// The boxes of a grid whose points have been computed.
class BoxMap {
 public:
  BoxMap(const SuiteSpace& space, const SuiteGrid& grid, GridFigures figures);

  /// The best that are apart from each other by more than that part of a box, best first.
  [[nodiscard]] std::vector<BoxedDamper> best(const SuiteGoal& goal, std::size_t most,
                                              double part = 1) const;
  /// How many keep the limits.
  [[nodiscard]] std::int64_t admissible(const SuiteGoal& goal) const;

 private:
  [[nodiscard]] SuitePlace logs(std::size_t box) const;
  [[nodiscard]] std::size_t depth(const std::vector<SuiteRank>& ranks, std::size_t box) const;

  const SuiteSpace& space_;
  SuiteGrid grid_;
  GridFigures worst_;
};

}  // namespace stillpoint::design
