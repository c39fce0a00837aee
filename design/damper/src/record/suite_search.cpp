// SPDX-License-Identifier: MIT

// The objective jumps where a motion rests elsewhere, and has dozens of local minima, so a search
// from one start fails: a scan, then local searches from its best valleys, and a global one
// as a second opinion. The scan is too coarse for thin islands, so slices through the best points,
// with one variable fixed, and ever smaller boxes around the best are scanned as well. With three
// variables the best points then breed: suite_population.cpp.

#include "record/suite_search.hpp"

#include "record/suite_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr std::size_t most_starts = 10;
/// For zero to three variables: the median of what the suites of docs/records-design.md take.
constexpr std::array<std::int64_t, 4> usual{0, 12'000, 35'000, 110'000};
/// Slices go through this many points, farther apart than this in some coordinate.
constexpr std::size_t sliced_points = 2;
constexpr double apart = 0.05;
constexpr std::int64_t slice_points = 2304;  ///< a line, or 48 by 48
constexpr std::size_t slice_starts = 3;
constexpr int most_slice_rounds = 4;
/// Around the best: this many points per side, from a reach in each coordinate down to a 64th of
/// it.
constexpr std::int64_t zoom_side_of_two = 36;
constexpr std::int64_t zoom_side_of_three = 11;
constexpr double first_reach = 0.04;
constexpr double last_reach = first_reach / 64;
constexpr double shrinkage = 0.25;
constexpr int most_zooms = 12;
constexpr std::int64_t fine_side = 1000;  ///< whose cell is the first step of the last descent
/// Of a coordinate: a millionth of the range of f or delta is as good as none, if the objective is
/// no more than a millionth worse without it.
constexpr double vanishing = 1e-3;

/// The best of `found` that are far enough apart.
std::vector<RankedPoint> apart_of(std::vector<RankedPoint> found) {
  std::ranges::stable_sort(found, {}, &RankedPoint::rank);
  std::vector<RankedPoint> list;
  for (RankedPoint& each : found) {
    const bool is_new = std::ranges::none_of(list, [&](const RankedPoint& other) {
      return std::equal(each.unit.begin(), each.unit.end(), other.unit.begin(),
                        [](double one, double two) { return std::abs(one - two) <= apart; });
    });
    if (is_new && list.size() < sliced_points) {
      list.push_back(std::move(each));
    }
  }
  return list;
}

class Search {
 public:
  explicit Search(const SuitePoints& points) : points_(points), box_(points_.box()) {}

  SuiteOptimum run(const SuiteScan& scan) {
    const std::vector<RankedPoint> starts = points_.valleys_of(scan, most_starts);
    best_ = starts.front();
    if (box_.variables() > 0 && !points_.stopped()) {
      std::vector<RankedPoint> found = descend(starts, scan.side, true);
      if (box_.variables() > 1) {
        slice(found);
      }
      if (box_.variables() > 2) {
        breed(found);
      }
    }
    leave_out_what_vanishes();
    result_.point = {box_.at(best_.unit), best_.figures};
    result_.evaluations += points_.evaluations();
    return result_;
  }

 private:
  /// From each start of a grid with this many points per side. Returns where each ends.
  std::vector<RankedPoint> descend(const std::vector<RankedPoint>& starts, std::int64_t side,
                                   bool global = false) {
    std::vector<RankedPoint> ends;
    for (SuiteDescent& each : descents(points_, starts, 1 / static_cast<double>(side), global)) {
      result_.evaluations += each.evaluations;
      keep(each.best, each.algorithm, each.status);
      ends.push_back(std::move(each.best));
    }
    return ends;
  }

  /// Until the slices through the best points find no better one.
  void slice(std::vector<RankedPoint>& found) {
    for (int round = 0; round < most_slice_rounds; ++round) {
      std::vector<RankedPoint> starts;
      for (const RankedPoint& through : apart_of(found)) {
        for (std::size_t fixed = 0; fixed < box_.variables(); ++fixed) {
          if (points_.stopped()) {
            return;
          }
          std::ranges::move(valleys_of_slice(through.unit, fixed), std::back_inserter(starts));
        }
      }
      const SuiteRank before = best_.rank;
      std::ranges::move(descend(starts, slice_side()), std::back_inserter(found));
      zoom();
      std::ranges::move(descend({best_}, fine_side), std::back_inserter(found));
      if (!is_better(before)) {
        return;
      }
    }
  }

  [[nodiscard]] std::int64_t slice_side() const {
    return box_.variables() == 3 ? 48 : slice_points;
  }

  /// Valleys of the grid through a point in all variables but one.
  std::vector<RankedPoint> valleys_of_slice(const std::vector<double>& through, std::size_t fixed) {
    const SuiteScan grid{slice_side(), {}};
    std::vector<std::vector<double>> units;
    for (std::size_t i = 0; i < slice_points; ++i) {
      std::vector<double> unit = grid.unit(i, box_.variables() - 1);
      unit.insert(unit.begin() + static_cast<std::ptrdiff_t>(fixed), through[fixed]);
      units.push_back(std::move(unit));
    }
    std::vector<RankedPoint> points = points_.all_ranked(std::move(units));
    std::vector<SuiteRank> ranks;
    ranks.reserve(points.size());
    for (const RankedPoint& each : points) {
      ranks.push_back(each.rank);
    }
    std::vector<RankedPoint> list;
    for (const std::size_t i : valleys(grid.side, box_.variables() - 1, ranks, slice_starts)) {
      list.push_back(std::move(points[i]));
    }
    return list;
  }

  /// Scans boxes around the best point, where a local search is caught between limits: if it finds
  /// a better one, around that, else a smaller box.
  void zoom() {
    const SuiteScan grid{box_.variables() == 3 ? zoom_side_of_three : zoom_side_of_two, {}};
    std::size_t size = 1;
    for (std::size_t i = 0; i < box_.variables(); ++i) {
      size *= static_cast<std::size_t>(grid.side);
    }
    double reach = first_reach;
    for (int i = 0; i < most_zooms && reach > last_reach / 2 && !points_.stopped(); ++i) {
      std::vector<std::vector<double>> units;
      for (std::size_t index = 0; index < size; ++index) {
        std::vector<double> unit = grid.unit(index, box_.variables());
        for (std::size_t k = 0; k < unit.size(); ++k) {
          unit[k] = std::clamp(best_.unit[k] + reach * (2 * unit[k] - 1), 0.0, 1.0);
        }
        units.push_back(std::move(unit));
      }
      const SuiteRank before = best_.rank;
      for (const RankedPoint& now : points_.all_ranked(std::move(units))) {
        keep(now, "scan", "SUCCESS");
      }
      if (!is_better(before)) {
        reach *= shrinkage;
      }
    }
  }

  void breed(const std::vector<RankedPoint>& found) {
    const std::vector<RankedPoint> ends = bred(points_, found, best_);
    for (const RankedPoint& end : ends) {
      keep(end, "scan", "SUCCESS");
    }
    descend(ends, fine_side);
  }

  void keep(const RankedPoint& now, const char* algorithm, const std::string& status) {
    if (now.rank < best_.rank) {
      best_ = now;
      result_.algorithm = algorithm;
      result_.status = status;
    }
  }

  /// Than it was, by more than rounding.
  [[nodiscard]] bool is_better(const SuiteRank& before) const {
    return best_.rank.off < before.off || best_.rank.value < before.value * (1 - no_difference);
  }

  /// A search creeps towards a friction of 0 and never reaches it. This takes at most two more
  /// dampers, so it is done after a stop as well.
  void leave_out_what_vanishes() {
    for (std::size_t i = 0; i < best_.unit.size(); ++i) {
      if (box_.may_vanish(i) && best_.unit[i] > 0 && best_.unit[i] < vanishing) {
        std::vector<double> without = best_.unit;
        without[i] = 0;
        const RankedPoint now = points_.ranked(std::move(without));
        if (now.rank.off <= best_.rank.off &&
            now.rank.value <= best_.rank.value * (1 + no_difference)) {
          best_ = now;
        }
      }
    }
  }

  SuitePoints points_;
  const SuiteBox& box_;
  RankedPoint best_;
  SuiteOptimum result_{{}, "scan", "SUCCESS", 0};
};

}  // namespace

std::int64_t usual_evaluations(const SuiteBox& box) {
  return usual.at(box.variables());
}

SuiteOptimum optimum(const Suite& suite, const SuiteBox& box, const SuiteScan& scan,
                     SuiteObjective objective, const SuiteLimits& limits, const Threads& threads,
                     SuiteWatch& watch) {
  return Search({suite, box, objective, limits, threads, watch}).run(scan);
}

}  // namespace stillpoint::design
