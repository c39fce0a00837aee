// SPDX-License-Identifier: MIT
#include "arrivals_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(arrivals_scan_test)

// The best damper that stops the mass at a later arrival. The truth is the half-cycle map forwards,
// in long double; the library follows it backwards.

namespace {

using namespace stillpoint::design_test;
using namespace stillpoint::design_test::of_arrivals;

/// Of a cost or of R, as in search_test.
constexpr double cost_tolerance = 1e-8;
/// Error in R of the scan of 60 by 60 points, absolute.
constexpr double scan_miss = 0.03;
/// The arrival at which the mass stops at x = 0 with the peak within beta; 0 if there is none. The
/// published criterion asks at the last arrival that the speed at x = f/p^2 be small enough.
int arrival_by_map(const Problem& problem, Wide f, Wide delta) {
  const Wide phi = f / problem.p;
  const Wide d = 2 * delta;
  const Wide v0 = problem.v0;
  if (v0 * v0 < d) {
    return 0;
  }
  Wide r = std::sqrt(v0 * v0 + phi * phi);
  if (r - phi > Wide(problem.p) * problem.beta) {
    return 0;
  }
  for (int n = 1; n <= problem.arrivals; ++n) {
    if (r < 3 * phi) {
      return 0;
    }
    const Wide t = r - 2 * phi;
    const Wide arrival = t * t - phi * phi;
    if (problem.criterion == Criterion::published ? t * t < d : arrival < d) {
      return n;
    }
    if (arrival < d) {
      return 0;  // it stops here, but the published criterion does not guarantee it
    }
    r = std::sqrt(t * t - d);
  }
  return 0;
}

bool box_by_map(const Problem& problem, const Limits& limits, Wide f, Wide delta, Wide r) {
  const int low = arrival_by_map(problem, f * (1 - r), delta * (1 - r));
  return low > 0 && low == arrival_by_map(problem, f * (1 + r), delta * (1 + r)) &&
         within_limits(problem, limits, f * (1 + r), delta * (1 + r));
}

Wide tolerance_by_map(const Problem& problem, const Limits& limits, Wide f, Wide delta) {
  if (!box_by_map(problem, limits, f, delta, 0)) {
    return -1;
  }
  Wide low = 0;
  Wide high = 1;
  while (high - low > 1e-12L) {
    const Wide middle = (low + high) / 2;
    (box_by_map(problem, limits, f, delta, middle) ? low : high) = middle;
  }
  return low;
}

double cost_of(Objective objective, const Problem& problem, double f, double delta) {
  return value_of(objective, free_response({problem.p, f, delta}, {0, problem.v0}));
}

/// Over f and Delta evenly and by factors.
std::vector<std::pair<double, double>> grid(const Problem& problem) {
  constexpr int steps = 60;
  std::vector<std::pair<double, double>> list;
  for (int i = 1; i <= steps; ++i) {
    for (int j = 1; j <= steps; ++j) {
      const double part = static_cast<double>(i) / steps;
      const double f = problem.v0 * problem.p * 0.36;
      const double delta = problem.v0 * problem.v0 * 0.5 * j / steps;
      list.emplace_back(f * part, delta);
      list.emplace_back(f * std::pow(10, -6 * part), delta);
    }
  }
  return list;
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_point_of_a_dense_scan_is_better) {
  RandomSource random(901);
  int found_later = 0;
  int empty = 0;
  for (int i = 0; i < 60; ++i) {
    const Task task = random_task(random);
    const auto& [problem, limits, seed] = task;
    const auto points = grid(problem);
    for (const Objective objective : objectives) {
      BOOST_TEST_CONTEXT(name(objective) << ", " << context_of(task)) {
        double best = HUGE_VAL;
        for (const auto& [f, delta] : points) {
          if (objective == Objective::robust) {
            const Wide tolerance = tolerance_by_map(problem, limits, f, delta);
            if (tolerance >= limits.tolerance) {
              best = std::min(best, -static_cast<double>(tolerance));
            }
          } else if (box_by_map(problem, limits, f, delta, limits.tolerance)) {
            best = std::min(best, cost_of(objective, problem, f, delta));
          }
        }
        const auto found = search(problem, limits, {objective, {}, 20'000, 10});
        if (!found) {
          ++empty;
          BOOST_TEST(best == HUGE_VAL);
          continue;
        }
        const DesignPoint& point = found->point;
        found_later += arrival_of(problem, point.f, point.delta).value() > 1;
        BOOST_TEST(point.tolerance >= limits.tolerance);
        BOOST_TEST(std::abs(point.tolerance - static_cast<double>(tolerance_by_map(
                                                  problem, limits, point.f, point.delta))) < 1e-11);
        if (objective == Objective::robust) {
          BOOST_TEST(-point.tolerance <= best + cost_tolerance);
          BOOST_TEST((best == HUGE_VAL || -point.tolerance >= best - scan_miss));
        } else {
          BOOST_TEST(cost_of(objective, problem, point.f, point.delta) <=
                     best * (1 + cost_tolerance));
        }
      }
    }
  }
  BOOST_TEST(found_later > 30);
  BOOST_TEST(empty > 4);
}

BOOST_AUTO_TEST_CASE(the_room_along_the_reach_edge_changes_its_sign_once) {
  // (50) with both sides followed back by (39), in long double; phi_b = 1.
  const auto square = [](Wide phi, Wide d, Wide radius, int steps) {
    for (int i = 0; i < steps; ++i) {
      radius = 2 * phi + std::sqrt(radius * radius + d);
    }
    return radius * radius - phi * phi;
  };
  int changed = 0;
  for (const int n : {2, 3, 4, 5, 7, 10, 20, 50, 200}) {
    // Above kappa = 1 - 1/n the room is positive at last, (51); at 1 it is an identity.
    for (int k = 1; k < 60; ++k) {
      const Wide kappa = Wide(k) / 60;
      int changes = 0;
      bool positive = false;
      for (int i = 0; i <= 600; ++i) {
        const Wide delta = std::pow(Wide(10), -6 + Wide(i) / 40);
        const bool now = square(kappa, kappa * delta, kappa, n) > square(1, delta, 3, n - 1);
        changes += now != positive;
        positive = now;
      }
      BOOST_TEST(changes <= 1, "n = " << n << ", kappa = " << static_cast<double>(kappa));
      changed += changes;
    }
  }
  BOOST_TEST(changed > 20);
}

BOOST_AUTO_TEST_CASE(the_search_finds_the_tolerance_of_the_closed_form) {
  RandomSource random(902);
  int later = 0;
  for (int i = 0; i < 300; ++i) {
    Task task = random_task(random);
    task.limits.tolerance = 0;
    const auto found = search(task.problem, task.limits);
    const auto list = strips(task.problem, task.limits);
    BOOST_TEST(found.has_value() == !list.empty());
    if (found && !list.empty()) {
      const auto best = std::ranges::max_element(list, {}, &Strip::tolerance);
      later += best->arrival > 1;
      BOOST_TEST(std::abs(found->point.tolerance - best->tolerance) <= cost_tolerance,
                 context_of(task) << ": " << found->point.tolerance << " found, " << best->tolerance
                                  << " by the closed form");
    }
  }
  BOOST_TEST(later > 50);
}

BOOST_AUTO_TEST_SUITE_END()
