// SPDX-License-Identifier: MIT

// The objective jumps where a motion rests elsewhere, and has dozens of local minima, so a search
// from one start fails: a scan, then local searches from its best valleys, and a global one
// as a second opinion. The scan is too coarse for thin islands, so slices through the best points,
// with one variable fixed, and ever smaller boxes around the best are scanned as well. With three
// variables the best points then breed: SuiteOffspring.

#include "record/suite_search.hpp"

#include "record/suite_offspring.hpp"
#include "record/suite_valleys.hpp"

#include "search/nlopt_fence.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr std::size_t most_starts = 10;
/// For zero to three variables: the median of what the suites of docs/records-design.md take.
constexpr std::array<std::int64_t, 4> usual{0, 12'000, 35'000, 110'000};
/// SBPLX stops by itself after about 300 with two variables; a jump can keep it busy.
constexpr int local_evaluations = 1000;
constexpr int global_evaluations = 10'000;
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
constexpr std::int64_t fine_side = 1000;  ///< whose cell is the first step of the last descent
/// Of a coordinate: a millionth of the range of f or delta is as good as none, if the objective is
/// no more than a millionth worse without it.
constexpr double vanishing = 1e-3;
constexpr double no_difference = 1e-6;
/// No time limit ends a search, so the result does not depend on the machine.
constexpr double no_time_limit = 1e9;

/// A point with its rank. Of equal ones the first is kept.
struct Ranked {
  std::vector<double> unit;
  SuiteFigures figures;
  SuiteRank rank{};
};

/// One number for NLopt in the order of the ranks: admissible below 1, others above.
double merit(const SuiteRank& rank) {
  return rank.off > 0 ? 1 + rank.off : rank.value / (1 + rank.value);
}

/// Leaves NLopt if the user has stopped the search.
struct Stopped {};

class Search {
 public:
  Search(const Suite& suite, const SuiteBox& box, SuiteObjective objective,
         const SuiteLimits& limits, int threads, SuiteWatch& watch)
      : suite_(suite),
        box_(box),
        objective_(objective),
        limits_(limits),
        threads_(threads),
        watch_(watch) {}

  SuiteOptimum run(const SuiteScan& scan) {
    std::vector<Ranked> starts = best_of(scan, {}, most_starts);
    best_ = starts.front();
    if (box_.variables() > 0 && !watch_.stopped()) {
      std::vector<Ranked> found = descend(starts, scan.side, true);
      if (box_.variables() > 1) {
        slice(found);
      }
      if (box_.variables() > 2) {
        descend(bred(std::move(found)), fine_side, false);
      }
    }
    leave_out_what_vanishes();
    result_.point = {box_.at(best_.unit), best_.figures};
    return result_;
  }

 private:
  [[nodiscard]] SuiteRank rank_of(const SuiteFigures& figures) const {
    return rank(figures, objective_, limits_);
  }

  Ranked ranked(std::vector<double> unit) {
    const SuiteDamper damper = box_.at(unit);
    const SuiteFigures figures = suite_.figures(damper);
    watch_.evaluated({&damper, 1}, {&figures, 1});
    return {std::move(unit), figures, rank_of(figures)};
  }

  /// The best valleys of a scan of the box, or of a slice of it, whose points are `units`.
  [[nodiscard]] std::vector<Ranked> best_of(const SuiteScan& scan,
                                            const std::vector<std::vector<double>>& units,
                                            std::size_t most) const {
    std::vector<SuiteRank> ranks;
    ranks.reserve(scan.figures.size());
    for (const SuiteFigures& figures : scan.figures) {
      ranks.push_back(rank_of(figures));
    }
    const std::size_t variables = box_.variables() - (units.empty() ? 0 : 1);
    std::vector<Ranked> list;
    for (const std::size_t i : valleys(scan.side, variables, ranks, most)) {
      list.push_back(
          {units.empty() ? scan.unit(i, variables) : units[i], scan.figures[i], ranks[i]});
    }
    return list;
  }

  /// Runs NLopt and keeps the best point that it tried, from `best` on.
  NloptOutcome improve(Ranked& best, const char* algorithm, double first_step, int evaluations) {
    const auto size = static_cast<Eigen::Index>(best.unit.size());
    NloptProblem problem;
    problem.lower = Eigen::VectorXd::Zero(size);
    problem.upper = Eigen::VectorXd::Ones(size);
    problem.start = Eigen::Map<const Eigen::VectorXd>(best.unit.data(), size);
    problem.first_step = first_step;
    int done = 0;
    problem.objective = [&](const Eigen::VectorXd& x, Eigen::VectorXd& /*gradient*/) {
      Ranked now = ranked({x.begin(), x.end()});
      const double value = merit(now.rank);
      if (now.rank < best.rank) {
        best = std::move(now);
      }
      ++done;
      if (watch_.stopped()) {
        throw Stopped();
      }
      return value;
    };
    try {
      return minimise(problem, algorithm, {evaluations, no_time_limit});
    } catch (const Stopped&) {
      return {{}, "INTERRUPTED", done};
    }
  }

  /// From each start of a grid with this many points per side; if asked, first a global search,
  /// which takes longest, and a descent from its best. Returns where each ends.
  std::vector<Ranked> descend(const std::vector<Ranked>& starts, std::int64_t side, bool global) {
    const std::size_t before = global ? 1 : 0;
    std::vector<Ranked> ends(starts.size() + before, starts.front());
    std::ranges::copy(starts, ends.begin() + static_cast<std::ptrdiff_t>(before));
    std::vector<NloptOutcome> outcomes(ends.size());
    const double step = 1 / static_cast<double>(side);
    for_each_entry(static_cast<std::ptrdiff_t>(ends.size()), threads_, {}, [&](std::ptrdiff_t i) {
      const auto index = static_cast<std::size_t>(i);
      int so_far = 0;
      if (index < before) {
        so_far = improve(ends[index], "GN_ISRES", 0, global_evaluations).evaluations;
      }
      outcomes[index] = improve(ends[index], "LN_SBPLX", step, local_evaluations);
      outcomes[index].evaluations += so_far;
    });
    for (std::size_t i = 0; i < ends.size(); ++i) {
      result_.evaluations += outcomes[i].evaluations;
      if (ends[i].rank < best_.rank) {
        best_ = ends[i];
        result_.algorithm = i < before ? "GN_ISRES" : "LN_SBPLX";
        result_.status = outcomes[i].status;
      }
    }
    return ends;
  }

  [[nodiscard]] std::int64_t slice_side() const {
    return box_.variables() == 3 ? 48 : slice_points;
  }

  /// Valleys of the grid through a point in all variables but one.
  std::vector<Ranked> valleys_of_slice(const std::vector<double>& through, std::size_t fixed) {
    SuiteScan grid;
    grid.side = slice_side();
    std::vector<std::vector<double>> units;
    for (std::size_t i = 0; i < slice_points; ++i) {
      std::vector<double> unit = grid.unit(i, box_.variables() - 1);
      unit.insert(unit.begin() + static_cast<std::ptrdiff_t>(fixed), through[fixed]);
      units.push_back(std::move(unit));
    }
    grid.figures = figures_at(units);
    return best_of(grid, units, slice_starts);
  }

  std::vector<SuiteFigures> figures_at(const std::vector<std::vector<double>>& units) {
    std::vector<SuiteDamper> dampers;
    dampers.reserve(units.size());
    for (const std::vector<double>& unit : units) {
      dampers.push_back(box_.at(unit));
    }
    std::vector<SuiteFigures> figures = suite_.figures(dampers, threads_);
    watch_.evaluated(dampers, figures);
    result_.evaluations += static_cast<std::int64_t>(units.size());
    return figures;
  }

  std::vector<Ranked> all_ranked(const std::vector<std::vector<double>>& units) {
    const std::vector<SuiteFigures> figures = figures_at(units);
    std::vector<Ranked> list;
    list.reserve(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
      list.push_back({units[i], figures[i], rank_of(figures[i])});
    }
    return list;
  }

  /// Scans boxes around the best point, where a local search is caught between limits: if it finds
  /// a better one, around that, else a smaller box.
  void zoom() {
    SuiteScan grid;
    grid.side = box_.variables() == 3 ? zoom_side_of_three : zoom_side_of_two;
    std::size_t size = 1;
    for (std::size_t i = 0; i < box_.variables(); ++i) {
      size *= static_cast<std::size_t>(grid.side);
    }
    double reach = first_reach;
    for (int i = 0; i < most_zooms && reach > last_reach / 2 && !watch_.stopped(); ++i) {
      std::vector<std::vector<double>> units;
      for (std::size_t index = 0; index < size; ++index) {
        std::vector<double> unit = grid.unit(index, box_.variables());
        for (std::size_t k = 0; k < unit.size(); ++k) {
          unit[k] = std::clamp(best_.unit[k] + reach * (2 * unit[k] - 1), 0.0, 1.0);
        }
        units.push_back(std::move(unit));
      }
      const SuiteRank before = best_.rank;
      for (const Ranked& now : all_ranked(units)) {
        keep(now);
      }
      if (!is_better(before)) {
        reach *= shrinkage;
      }
    }
  }

  /// Than it was, by more than rounding.
  [[nodiscard]] bool is_better(const SuiteRank& before) const {
    return best_.rank.off < before.off || best_.rank.value < before.value * (1 - no_difference);
  }

  /// As `best`, but for rounding; the stroke decides between equal values.
  static bool as_good(const SuiteRank& rank, const SuiteRank& best) {
    constexpr double same = 1 + no_difference;
    if (best.off > 0) {
      return rank.off <= best.off * same;
    }
    return rank.off <= 0 && (rank.value == best.value ? rank.peak <= best.peak * same
                                                      : rank.value <= best.value * same);
  }

  /// The best of `found` that are far enough apart.
  static std::vector<Ranked> apart_of(std::vector<Ranked> found) {
    std::ranges::stable_sort(found, {}, &Ranked::rank);
    std::vector<Ranked> list;
    for (Ranked& each : found) {
      const bool is_new = std::ranges::none_of(list, [&](const Ranked& other) {
        for (std::size_t i = 0; i < each.unit.size(); ++i) {
          if (std::abs(each.unit[i] - other.unit[i]) > apart) {
            return false;
          }
        }
        return true;
      });
      if (is_new && list.size() < sliced_points) {
        list.push_back(std::move(each));
      }
    }
    return list;
  }

  /// Until the slices through the best points find no better one.
  void slice(std::vector<Ranked>& found) {
    for (int round = 0; round < most_slice_rounds; ++round) {
      std::vector<Ranked> starts;
      for (const Ranked& through : apart_of(found)) {
        for (std::size_t fixed = 0; fixed < box_.variables(); ++fixed) {
          if (watch_.stopped()) {
            return;
          }
          std::ranges::move(valleys_of_slice(through.unit, fixed), std::back_inserter(starts));
        }
      }
      const SuiteRank before = best_.rank;
      std::ranges::move(descend(starts, slice_side(), false), std::back_inserter(found));
      zoom();
      std::ranges::move(descend({best_}, fine_side, false), std::back_inserter(found));
      if (!is_better(before)) {
        return;
      }
    }
  }

  /// The best of each population: from all that was found, and points about the best of it.
  std::vector<Ranked> bred(std::vector<Ranked> found) {
    found.push_back(best_);
    const std::vector<double> middle = best_.unit;
    std::vector<Ranked> ends;
    const std::uint64_t most =
        suite_.loads().size() < many_records ? populations : populations_of_many;
    for (std::uint64_t population = 0; population < most; ++population) {
      SuiteOffspring offspring(population);
      std::vector<Ranked> kept = found;
      bool settled = false;
      for (int i = 0; i < most_generations && !settled && !watch_.stopped(); ++i) {
        add_generation(kept, i < 2 ? offspring.about(middle, generation)
                                   : offspring.of(units_of(kept), generation));
        settled = as_good(kept.back().rank, kept.front().rank);
      }
      keep(kept.front());
      ends.push_back(kept.front());
    }
    return ends;
  }

  void add_generation(std::vector<Ranked>& kept, const std::vector<std::vector<double>>& units) {
    std::ranges::move(all_ranked(units), std::back_inserter(kept));
    std::ranges::stable_sort(kept, {}, &Ranked::rank);
    kept.resize(std::min(kept.size(), kept_points));
  }

  static std::vector<std::vector<double>> units_of(const std::vector<Ranked>& points) {
    std::vector<std::vector<double>> units;
    units.reserve(points.size());
    for (const Ranked& each : points) {
      units.push_back(each.unit);
    }
    return units;
  }

  /// Keeps it if it is better: from a scan, not from NLopt.
  void keep(const Ranked& now) {
    if (now.rank < best_.rank) {
      best_ = now;
      result_.algorithm = "scan";
      result_.status = "SUCCESS";
    }
  }

  /// A search creeps towards a friction of 0 and never reaches it. This takes at most two more
  /// dampers, so it is done after a stop as well.
  void leave_out_what_vanishes() {
    for (std::size_t i = 0; i < best_.unit.size(); ++i) {
      if (box_.may_vanish(i) && best_.unit[i] > 0 && best_.unit[i] < vanishing) {
        std::vector<double> without = best_.unit;
        without[i] = 0;
        const Ranked now = ranked(std::move(without));
        if (now.rank.off <= best_.rank.off &&
            now.rank.value <= best_.rank.value * (1 + no_difference)) {
          best_ = now;
        }
      }
    }
  }

  const Suite& suite_;
  const SuiteBox& box_;
  SuiteObjective objective_;
  SuiteLimits limits_;
  int threads_;
  SuiteWatch& watch_;
  Ranked best_;
  SuiteOptimum result_{{}, "scan", "SUCCESS", 0};
};

}  // namespace

std::int64_t usual_evaluations(const SuiteBox& box) {
  return usual.at(box.variables());
}

SuiteOptimum optimum(const Suite& suite, const SuiteBox& box, const SuiteScan& scan,
                     SuiteObjective objective, const SuiteLimits& limits, int threads,
                     SuiteWatch& watch) {
  return Search(suite, box, objective, limits, threads, watch).run(scan);
}

}  // namespace stillpoint::design
