// SPDX-License-Identifier: MIT
#include "record/suite_points.hpp"

#include "record/suite_offspring.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace stillpoint::design {

namespace {

/// A population ends where all that it keeps are equally good, on most suites after ten to forty
/// generations. Of ridges that differ by a hundredth (the last suite of docs/records-design.md) one
/// population in three ends on the best, so that there are eight.
constexpr std::size_t kept_points = 150;
constexpr std::size_t generation = 300;
constexpr int most_generations = 250;
constexpr std::uint64_t populations = 8;
/// The figures of many records together are smoother, and take longer.
constexpr std::size_t many_records = 7;
constexpr std::uint64_t populations_of_many = 3;

/// As `best`, but for rounding; the stroke decides between equal values.
bool as_good(const SuiteRank& rank, const SuiteRank& best) {
  constexpr double same = 1 + no_difference;
  if (best.off > 0) {
    return rank.off <= best.off * same;
  }
  return rank.off <= 0 && (rank.value == best.value ? rank.peak <= best.peak * same
                                                    : rank.value <= best.value * same);
}

std::vector<std::vector<double>> units_of(const std::vector<RankedPoint>& points) {
  std::vector<std::vector<double>> units;
  units.reserve(points.size());
  for (const RankedPoint& each : points) {
    units.push_back(each.unit);
  }
  return units;
}

void add_generation(SuitePoints& points, std::vector<RankedPoint>& kept,
                    std::vector<std::vector<double>> units) {
  std::ranges::move(points.all_ranked(std::move(units)), std::back_inserter(kept));
  std::ranges::stable_sort(kept, {}, &RankedPoint::rank);
  kept.resize(std::min(kept.size(), kept_points));
}

}  // namespace

std::vector<RankedPoint> bred(SuitePoints& points, const std::vector<RankedPoint>& found,
                              const RankedPoint& best) {
  const std::uint64_t most = points.records() < many_records ? populations : populations_of_many;
  std::vector<RankedPoint> ends;
  for (std::uint64_t population = 0; population < most; ++population) {
    SuiteOffspring offspring(population);
    std::vector<RankedPoint> kept = found;
    kept.push_back(best);
    bool settled = false;
    for (int i = 0; i < most_generations && !settled && !points.stopped(); ++i) {
      add_generation(points, kept,
                     i < 2 ? offspring.about(best.unit, generation)
                           : offspring.of(units_of(kept), generation));
      settled = as_good(kept.back().rank, kept.front().rank);
    }
    ends.push_back(kept.front());
  }
  return ends;
}

}  // namespace stillpoint::design
