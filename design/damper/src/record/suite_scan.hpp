// SPDX-License-Identifier: MIT
#pragma once

#include "record/suite.hpp"
#include "record/suite_watch.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stillpoint::design {

/// The box of a search in coordinates from 0 to 1. f and delta vary as their squares, because delta
/// matters through the speed sqrt(2 delta), and because small frictions need a fine scan; p varies
/// as the period 1/p. A range of one value is not a variable.
class SuiteBox {
 public:
  explicit SuiteBox(const RecordDesignRequest& request);

  [[nodiscard]] std::size_t variables() const { return variables_.size(); }
  /// Whether the coordinate 0 is a friction of 0.
  [[nodiscard]] bool may_vanish(std::size_t variable) const {
    return (variables_[variable] == Variable::f && f_.low == 0) ||
           (variables_[variable] == Variable::delta && delta_.low == 0);
  }
  [[nodiscard]] SuiteDamper at(const std::vector<double>& unit) const;

 private:
  enum class Variable { f, delta, p };
  Interval f_;
  Interval delta_;
  Interval p_;
  std::vector<Variable> variables_;
};

/// A grid over the box, and the figures of each of its points; those that were not evaluated do not
/// settle.
struct SuiteScan {
  std::int64_t side{1};  ///< points along each variable
  std::vector<SuiteFigures> figures;

  /// In [0, 1]; the last variable runs fastest.
  [[nodiscard]] std::vector<double> unit(std::size_t index, std::size_t variables) const;
};

/// Points along each variable of a grid of about `points`, and in all.
struct GridSize {
  std::int64_t side{1};
  std::int64_t all{1};
};
[[nodiscard]] GridSize grid_size(const SuiteBox& box, std::int64_t points);

/// The figures of the `count` points of a grid; fewer after a stop.
[[nodiscard]] std::vector<SuiteFigures> grid_figures(const Suite& suite, const SuiteBox& box,
                                                     std::int64_t side, std::int64_t count,
                                                     const Threads& threads, SuiteWatch& watch);

}  // namespace stillpoint::design
