// SPDX-License-Identifier: MIT

// The objective jumps where a motion rests elsewhere, and has dozens of local minima, so that a
// search from one start fails: a scan, then local searches from its best valleys, and a global one
// as a second opinion.

#include "suite_search.hpp"

#include "nlopt_fence.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr std::size_t most_starts = 10;
/// SBPLX stops by itself after some 300 of two variables; a jump can keep it busy.
constexpr int local_evaluations = 1000;
constexpr int global_evaluations = 10'000;
/// Of a coordinate: a millionth of the range of f or delta is as good as none, if the objective is
/// no more than a millionth worse without it.
constexpr double vanishing = 1e-3;
constexpr double no_difference = 1e-6;
/// No time ends a search, so that the result depends on no machine.
constexpr double no_time_limit = 1e9;

double square_between(const SearchRange& range, double unit) {
  return unit == 1 ? range.high : range.low + (range.high - range.low) * unit * unit;
}

double period_between(const SearchRange& p, double unit) {
  return unit == 0   ? p.high
         : unit == 1 ? p.low
                     : 1 / (1 / p.high + (1 / p.low - 1 / p.high) * unit);
}

/// A point with its rank. Of equal ones the first stays.
struct Ranked {
  std::vector<double> unit;
  SuiteFigures figures;
  SuiteRank rank{};
};

/// One number for NLopt in the order of the ranks: admissible below 1, others above.
double merit(const SuiteRank& rank) {
  return rank.off > 0 ? 1 + rank.off : rank.value / (1 + rank.value);
}

/// The points of the scan that no neighbour betters, best first.
std::vector<std::size_t> valleys(const SuiteScan& scan, std::size_t variables,
                                 const std::vector<SuiteRank>& ranks) {
  const auto side = static_cast<std::size_t>(scan.side);
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
  return list;
}

/// Runs NLopt and keeps the best point that it tried, from `best` on.
NloptOutcome improve(Ranked& best, const std::function<Ranked(std::vector<double>)>& ranked,
                     const char* algorithm, double first_step, int evaluations) {
  const auto size = static_cast<Eigen::Index>(best.unit.size());
  NloptProblem problem;
  problem.lower = Eigen::VectorXd::Zero(size);
  problem.upper = Eigen::VectorXd::Ones(size);
  problem.start = Eigen::Map<const Eigen::VectorXd>(best.unit.data(), size);
  problem.first_step = first_step;
  problem.objective = [&](const Eigen::VectorXd& x, Eigen::VectorXd& /*gradient*/) {
    Ranked now = ranked({x.begin(), x.end()});
    const double value = merit(now.rank);
    if (now.rank < best.rank) {
      best = std::move(now);
    }
    return value;
  };
  return minimise(problem, algorithm, {evaluations, no_time_limit});
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

SuiteScan scan(const Suite& suite, const SuiteBox& box, std::int64_t points, int threads) {
  SuiteScan scan;
  std::int64_t size = 1;
  if (box.variables() > 0) {
    const double root =
        std::pow(static_cast<double>(points), 1.0 / static_cast<double>(box.variables()));
    scan.side = std::max<std::int64_t>(2, std::llround(root));
    for (std::size_t i = 0; i < box.variables(); ++i) {
      size *= scan.side;
    }
  }
  std::vector<SuiteDamper> dampers;
  dampers.reserve(static_cast<std::size_t>(size));
  for (std::size_t i = 0; i < static_cast<std::size_t>(size); ++i) {
    dampers.push_back(box.at(scan.unit(i, box.variables())));
  }
  scan.figures = suite.figures(dampers, threads);
  return scan;
}

SuiteOptimum optimum(const Suite& suite, const SuiteBox& box, const SuiteScan& scan,
                     SuiteObjective objective, const SuiteLimits& limits, int threads) {
  std::vector<SuiteRank> ranks;
  ranks.reserve(scan.figures.size());
  for (const SuiteFigures& figures : scan.figures) {
    ranks.push_back(rank(figures, objective, limits));
  }
  const auto ranked = [&](std::vector<double> unit) {
    const SuiteFigures figures = suite.figures(box.at(unit));
    return Ranked{std::move(unit), figures, rank(figures, objective, limits)};
  };
  std::vector<std::size_t> starts = valleys(scan, box.variables(), ranks);
  starts.resize(std::min(starts.size(), most_starts));
  const auto at = [&](std::size_t index) {
    return Ranked{scan.unit(index, box.variables()), scan.figures[index], ranks[index]};
  };
  Ranked best = at(starts.front());
  SuiteOptimum found{{}, "scan", "SUCCESS", 0};
  if (box.variables() > 0) {
    // The global search takes longest, so it begins first.
    struct Run {
      Ranked best;
      NloptOutcome outcome;
    };
    std::vector<Run> runs(starts.size() + 1);
    const double step = 1 / static_cast<double>(scan.side);
    for_each_entry(static_cast<std::ptrdiff_t>(runs.size()), threads, {}, [&](std::ptrdiff_t i) {
      Run& run = runs[static_cast<std::size_t>(i)];
      run.best = at(starts[i == 0 ? 0 : static_cast<std::size_t>(i) - 1]);
      if (i == 0) {
        run.outcome = improve(run.best, ranked, "GN_ISRES", 0, global_evaluations);
        const int so_far = run.outcome.evaluations;
        run.outcome = improve(run.best, ranked, "LN_SBPLX", step, local_evaluations);
        run.outcome.evaluations += so_far;
      } else {
        run.outcome = improve(run.best, ranked, "LN_SBPLX", step, local_evaluations);
      }
    });
    for (std::size_t i = 0; i < runs.size(); ++i) {
      found.evaluations += runs[i].outcome.evaluations;
      if (runs[i].best.rank < best.rank) {
        best = runs[i].best;
        found.algorithm = i == 0 ? "GN_ISRES" : "LN_SBPLX";
        found.status = runs[i].outcome.status;
      }
    }
  }
  // A search creeps towards a friction of 0 and never arrives.
  for (std::size_t i = 0; i < best.unit.size(); ++i) {
    if (box.may_vanish(i) && best.unit[i] > 0 && best.unit[i] < vanishing) {
      std::vector<double> without = best.unit;
      without[i] = 0;
      const Ranked now = ranked(std::move(without));
      if (now.rank.off <= best.rank.off &&
          now.rank.value <= best.rank.value * (1 + no_difference)) {
        best = now;
      }
    }
  }
  found.point = {box.at(best.unit), best.figures};
  return found;
}

}  // namespace stillpoint::design
