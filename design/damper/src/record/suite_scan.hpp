// SPDX-License-Identifier: MIT
#pragma once

// A scan of a space that is fine only where a design may be: docs/records-design.md section 2.

#include "record/suite_boxes.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace stillpoint::design {

/// How many dampers a scan may compute: what the task says for two variables, no more than that for
/// one, and four times as many for more.
[[nodiscard]] std::int64_t points_of_scan(const RecordDesignRequest& task, const SuiteSpace& space,
                                          std::int64_t of_a_line);

/// The points of the finest grid that have been computed: first every so many steps, then half as
/// many, where a neighbour allows a design between.
class SuiteScan {
 public:
  SuiteScan(const Suites& suite, const SuiteSpace& space, std::int64_t points,
            const Threads& threads, SuiteWatch& watch);

  /// Looks for designs within the limits that are better than `bar`. A step that would compute more
  /// than the given number of points is not taken.
  void look(const SuiteGoal& goal, double bar);

  /// Whether a damper may be within those of the limits that change smoothly with it, as far as the
  /// points tell.
  [[nodiscard]] bool may_have(const SuiteGoal& goal) const;

  /// Of the dampers that were computed, the one that is off the limits least.
  [[nodiscard]] std::optional<SuiteDamper> nearest(const SuiteGoal& goal) const;

  /// The grid of the last look, its points, where those that were not computed count as unsettled,
  /// and its boxes.
  [[nodiscard]] SuiteGrid grid() const;
  [[nodiscard]] GridFigures figures() const;
  [[nodiscard]] BoxMap map() const { return {space_, grid(), figures()}; }
  [[nodiscard]] std::int64_t computed() const { return std::ssize(figures_); }

 private:
  using Index = std::array<std::int64_t, most_axes>;

  [[nodiscard]] std::size_t flat(const Index& index) const;
  [[nodiscard]] double longest_step() const;
  [[nodiscard]] std::vector<Index> of_stride(std::int64_t stride) const;
  [[nodiscard]] std::int64_t points_of_stride(std::int64_t stride) const;
  [[nodiscard]] bool has_promising_neighbour(const Index& index, std::int64_t stride,
                                             const SuiteGoal& goal, double bar) const;
  [[nodiscard]] SuitePlace place(const Index& index) const;
  void compute(const std::vector<Index>& list);
  /// Null if the point was not computed.
  [[nodiscard]] const TaskFigures* known(const Index& index) const;

  const Suites& suite_;
  const SuiteSpace& space_;
  std::int64_t points_;
  const Threads& threads_;
  SuiteWatch& watch_;
  SuiteGrid finest_;
  std::int64_t first_stride_{1};
  std::int64_t stride_{1};
  std::vector<TaskFigures> figures_;  // of the points that were computed
  std::vector<std::int64_t> row_;     // of each point in these; -1: it was not
};

}  // namespace stillpoint::design
