// SPDX-License-Identifier: MIT
#include "record/suite_points.hpp"

#include <algorithm>
#include <utility>

namespace stillpoint::design {

RankedPoint SuitePoints::ranked(std::vector<double> unit) const {
  const SuiteDamper damper = box_.at(unit);
  const SuiteFigures figures = suite_.figures(damper);
  watch_.evaluated({&damper, 1}, {&figures, 1});
  return {std::move(unit), figures, rank(figures, objective_, limits_)};
}

std::vector<RankedPoint> SuitePoints::all_ranked(std::vector<std::vector<double>> units) {
  std::vector<SuiteDamper> dampers;
  dampers.reserve(units.size());
  for (const std::vector<double>& unit : units) {
    dampers.push_back(box_.at(unit));
  }
  const std::vector<SuiteFigures> figures = suite_.figures(dampers, threads_);
  watch_.evaluated(dampers, figures);
  evaluations_ += static_cast<std::int64_t>(units.size());
  std::vector<RankedPoint> list;
  list.reserve(units.size());
  for (std::size_t i = 0; i < units.size(); ++i) {
    list.push_back({std::move(units[i]), figures[i], rank(figures[i], objective_, limits_)});
  }
  return list;
}

std::vector<RankedPoint> SuitePoints::valleys_of(const SuiteScan& scan, std::size_t most) const {
  std::vector<SuiteRank> ranks;
  ranks.reserve(scan.figures.size());
  for (const SuiteFigures& figures : scan.figures) {
    ranks.push_back(rank(figures, objective_, limits_));
  }
  std::vector<RankedPoint> list;
  for (const std::size_t i : valleys(scan.side, box_.variables(), ranks, most)) {
    list.push_back({scan.unit(i, box_.variables()), scan.figures[i], ranks[i]});
  }
  return list;
}

std::vector<std::size_t> valleys(std::int64_t points, std::size_t variables,
                                 const std::vector<SuiteRank>& ranks, std::size_t most) {
  const auto side = static_cast<std::size_t>(points);
  std::size_t around = 1;
  for (std::size_t i = 0; i < variables; ++i) {
    around *= 3;
  }
  const auto is_valley = [&](std::size_t index) {
    for (std::size_t step = 0; step < around; ++step) {
      std::size_t neighbour = 0;
      std::size_t stride = 1;
      bool inside = true;
      for (std::size_t i = 0, left = index, move = step; i < variables;
           ++i, left /= side, move /= 3, stride *= side) {
        const std::size_t place = left % side + move % 3;  // one more than the neighbour's
        inside = inside && place >= 1 && place <= side;
        neighbour += (place - 1) * stride;
      }
      if (inside && std::pair(ranks[neighbour], neighbour) < std::pair(ranks[index], index)) {
        return false;
      }
    }
    return true;
  };
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (is_valley(i)) {
      list.push_back(i);
    }
  }
  std::ranges::sort(list, {}, [&](std::size_t i) { return std::pair(ranks[i], i); });
  list.resize(std::min(list.size(), most));
  return list;
}

}  // namespace stillpoint::design
