// SPDX-License-Identifier: MIT
#include "record/suite_points.hpp"

#include "search/nlopt_fence.hpp"

#include <stillpoint/core/for_each_entry.hpp>

#include <cstddef>
#include <utility>

namespace stillpoint::design {

namespace {

constexpr auto local_algorithm = "LN_SBPLX";
constexpr auto global_algorithm = "GN_ISRES";
/// SBPLX stops by itself after about 300 with two variables; a jump can keep it busy.
constexpr int local_evaluations = 1000;
constexpr int global_evaluations = 10'000;
/// No time limit ends a search, so the result does not depend on the machine.
constexpr double no_time_limit = 1e9;

/// One number for NLopt in the order of the ranks: admissible below 1, others above.
double merit(const SuiteRank& rank) {
  return rank.off > 0 ? 1 + rank.off : rank.value / (1 + rank.value);
}

/// Leaves NLopt if the user has stopped the search.
struct Stopped {};

/// Runs NLopt on from the best point of `search`.
void improve(const SuitePoints& points, SuiteDescent& search, const char* algorithm,
             double first_step, int evaluations) {
  RankedPoint& best = search.best;
  const auto size = static_cast<Eigen::Index>(best.unit.size());
  NloptProblem problem;
  problem.lower = Eigen::VectorXd::Zero(size);
  problem.upper = Eigen::VectorXd::Ones(size);
  problem.start = Eigen::Map<const Eigen::VectorXd>(best.unit.data(), size);
  problem.first_step = first_step;
  const int before = search.evaluations;
  problem.objective = [&](const Eigen::VectorXd& x, Eigen::VectorXd& /*gradient*/) {
    RankedPoint now = points.ranked({x.begin(), x.end()});
    const double value = merit(now.rank);
    if (now.rank < best.rank) {
      best = std::move(now);
    }
    ++search.evaluations;
    if (points.stopped()) {
      throw Stopped();
    }
    return value;
  };
  try {
    const NloptOutcome outcome = minimise(problem, algorithm, {evaluations, no_time_limit});
    search.evaluations = before + outcome.evaluations;
    search.status = outcome.status;
  } catch (const Stopped&) {
    search.status = "INTERRUPTED";
  }
}

}  // namespace

std::vector<SuiteDescent> descents(const SuitePoints& points,
                                   const std::vector<RankedPoint>& starts, double first_step,
                                   bool global) {
  std::vector<SuiteDescent> searches;
  if (global) {
    searches.push_back({starts.front(), global_algorithm, {}});
  }
  for (const RankedPoint& start : starts) {
    searches.push_back({start, local_algorithm, {}});
  }
  for_each_entry(std::ssize(searches), points.threads(), {}, [&](std::ptrdiff_t i) {
    SuiteDescent& search = searches[static_cast<std::size_t>(i)];
    if (global && i == 0) {
      improve(points, search, global_algorithm, 0, global_evaluations);
    }
    improve(points, search, local_algorithm, first_step, local_evaluations);
  });
  return searches;
}

}  // namespace stillpoint::design
