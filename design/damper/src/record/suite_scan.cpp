// SPDX-License-Identifier: MIT
#include "record/suite_scan.hpp"

#include <stillpoint/core/elementary.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stillpoint::design {

namespace {

/// Dampers of a scan between two checks of whether to go on: with seven records, a fifth of a
/// second.
constexpr std::int64_t scan_block = 1000;

double square_between(const Interval& range, double unit) {
  return unit == 1 ? range.high : range.low + (range.high - range.low) * unit * unit;
}

double period_between(const Interval& p, double unit) {
  return unit == 0   ? p.high
         : unit == 1 ? p.low
                     : 1 / (1 / p.high + (1 / p.low - 1 / p.high) * unit);
}

}  // namespace

SuiteBox::SuiteBox(const RecordDesignRequest& request)
    : f_(request.f.value()), delta_(request.delta.value()), p_(request.p) {
  for (const auto& [range, variable] :
       {std::pair(&f_, Variable::f), std::pair(&delta_, Variable::delta),
        std::pair(&p_, Variable::p)}) {
    if (range->low < range->high) {
      variables_.push_back(variable);
    }
  }
}

SuiteDamper SuiteBox::at(const std::vector<double>& unit) const {
  SuiteDamper damper{p_.low, f_.low, delta_.low};
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    switch (variables_[i]) {
      case Variable::f:
        damper.f = square_between(f_, unit[i]);
        break;
      case Variable::delta:
        damper.delta = square_between(delta_, unit[i]);
        break;
      case Variable::p:
        damper.p = period_between(p_, unit[i]);
        break;
    }
  }
  return damper;
}

std::vector<double> SuiteScan::unit(std::size_t index, std::size_t variables) const {
  std::vector<double> unit(variables);
  for (std::size_t i = variables; i > 0; --i, index /= static_cast<std::size_t>(side)) {
    const auto place = static_cast<double>(index % static_cast<std::size_t>(side));
    unit[i - 1] = side > 1 ? place / static_cast<double>(side - 1) : 0;
  }
  return unit;
}

GridSize grid_size(const SuiteBox& box, std::int64_t points) {
  GridSize size;
  if (box.variables() > 0) {
    const double root =
        elementary::pow(static_cast<double>(points), 1.0 / static_cast<double>(box.variables()));
    size.side = std::max<std::int64_t>(2, std::llround(root));
    for (std::size_t i = 0; i < box.variables(); ++i) {
      size.all *= size.side;
    }
  }
  return size;
}

std::vector<SuiteFigures> grid_figures(const Suite& suite, const SuiteBox& box, std::int64_t side,
                                       std::int64_t count, const Threads& threads,
                                       SuiteWatch& watch) {
  const SuiteScan grid{side, {}};
  std::vector<SuiteFigures> all;
  all.reserve(static_cast<std::size_t>(count));
  std::vector<SuiteDamper> block;
  for (std::int64_t begin = 0; begin < count && !watch.stopped(); begin += scan_block) {
    block.clear();
    for (std::int64_t i = begin; i < std::min(begin + scan_block, count); ++i) {
      block.push_back(box.at(grid.unit(static_cast<std::size_t>(i), box.variables())));
    }
    const std::vector<SuiteFigures> figures = suite.figures(block, threads);
    all.insert(all.end(), figures.begin(), figures.end());
    watch.evaluated(block, figures);
  }
  return all;
}

}  // namespace stillpoint::design
