// SPDX-License-Identifier: MIT
#include "record/suite_points.hpp"

#include "record/suite_valleys.hpp"

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

}  // namespace stillpoint::design
