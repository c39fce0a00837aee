// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "by_map.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(search_test)

using namespace stillpoint::design_test;

/// Of a cost, relative (of R, absolute): the design stays a relative 1e-9 inside open edges.
constexpr double cost_tolerance = 1e-8;
/// Of the reported R: f and Delta themselves are rounded.
constexpr double reported_tolerance = 4e-15;
/// For the largest tolerance that the region allows: the rounding of its edges.
constexpr double last_digits = 2e-15;

DesignPoint find(const Task& task, Objective objective) {
  const auto result = search(task.problem, task.limits, {objective, {}, 20'000, 10});
  BOOST_REQUIRE(result.has_value());
  return result->point;
}

/// The point is admissible with the requested tolerance (minus `doubt`).
void check_admissible(const Task& task, const DesignPoint& point, double doubt = 0) {
  const double asked = std::max(0.0, task.limits.tolerance - doubt);
  BOOST_TEST(admissible(task.problem, with_tolerance(task.limits, asked), point.f, point.delta));
  BOOST_TEST(point.tolerance >= asked);
  for (const Constraint& constraint : constraints(task.problem, point.f, point.delta)) {
    BOOST_TEST(constraint.satisfied, constraint.name << ": slack " << constraint.slack);
  }
}

/// And it reports its own tolerance.
void check_point(const Task& task, const DesignPoint& point, double doubt = 0) {
  check_admissible(task, point, doubt);
  const double truth = by_map::tolerance(task, point.f, point.delta);
  BOOST_TEST(std::abs(point.tolerance - truth) <= reported_tolerance,
             point.tolerance << " reported, is " << truth);
}

/// Over f evenly, by factors and towards both ends of the first strip; over Delta evenly up to the
/// largest that a box may have.
std::vector<DesignPoint> grid(const Task& task) {
  const auto& [problem, limits, seed] = task;
  const double p_v0 = problem.p * problem.v0;
  const double stroke = problem.beta * problem.p;
  const double f2 = (problem.v0 - stroke) * (problem.v0 + stroke) / (2 * problem.beta);
  const double f_cap = std::min(p_v0 / std::sqrt(8.0), limits.f_max.value_or(HUGE_VAL));
  const double delta_cap =
      std::min(problem.v0 * problem.v0 / 2, limits.delta_max.value_or(HUGE_VAL));
  std::vector<DesignPoint> list;
  constexpr int steps = 40;
  for (int i = 1; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const double near = (f_cap - std::max(f2, 0.0)) * std::pow(10, -12 * part);
    for (const double f :
         {f_cap * part, f_cap * std::pow(10, -6 * part), f_cap - near, std::max(f2, 0.0) + near}) {
      for (int j = 1; j <= steps; ++j) {
        list.push_back({f / (1 + limits.tolerance),
                        delta_cap * (1 - 1e-12) * j / steps / (1 + limits.tolerance), 0});
      }
    }
  }
  return list;
}

double cost_of(Objective objective, const Problem& problem, double f, double delta) {
  return value_of(objective, free_response({problem.p, f, delta}, {0, problem.v0}));
}

/// Of those whose box holds; HUGE_VAL without any.
double least_cost(const Task& task, Objective objective, const std::vector<DesignPoint>& points) {
  double best = HUGE_VAL;
  for (const auto& [f, delta, unused] : points) {
    if (objective == Objective::robust) {
      const double least = std::max(task.limits.tolerance, best == HUGE_VAL ? 0 : -best);
      const double tolerance = by_map::tolerance(task, f, delta, least);
      best = tolerance < 0 ? best : std::min(best, -tolerance);
    } else if (by_map::box_holds(task, f, delta, task.limits.tolerance)) {
      best = std::min(best, cost_of(objective, task.problem, f, delta));
    }
  }
  return best;
}

/// An admissible f with its Delta is the best of those at that f: no other has more tolerance.
void check_delta(const Task& task, const DesignPoint& point) {
  constexpr int steps = 400;
  const double most = task.problem.v0 * task.problem.v0 / 2;
  for (int i = 1; i <= steps; ++i) {
    const double least = point.tolerance + reported_tolerance;
    BOOST_TEST(by_map::tolerance(task, point.f, most * i / steps, least) < 0);
  }
}

BOOST_AUTO_TEST_CASE(no_point_of_a_dense_scan_is_better) {
  RandomSource random(501);
  int found_first = 0;
  int found_later = 0;
  int empty = 0;
  for (int i = 0; i < 150; ++i) {
    const Task task = one_hit_task(random, 0.72, i % 2 == 0 ? 1.5 : 3);
    const auto& [problem, limits, seed] = task;
    const auto points = grid(task);
    for (const Objective objective : objectives) {
      BOOST_TEST_CONTEXT(name(objective) << ", task " << i << ", " << context_of(task)) {
        const double best = least_cost(task, objective, points);
        const auto found = search(problem, limits, {objective, {}, 20'000, 10});
        if (!found) {
          ++empty;
          BOOST_TEST(!task.feasible());
          BOOST_TEST(best == HUGE_VAL);
          continue;
        }
        const DesignPoint& point = found->point;
        ++(arrival_of(problem, point.f, point.delta).value() > 1 ? found_later : found_first);
        check_point(task, point);
        if (objective == Objective::robust) {
          BOOST_TEST(-point.tolerance <= best + cost_tolerance);
        } else {
          BOOST_TEST(cost_of(objective, problem, point.f, point.delta) <=
                     best * (1 + cost_tolerance));
        }
        if (problem.arrivals == 1) {
          check_delta(task, point);
        }
      }
    }
  }
  BOOST_TEST(found_first > 300);
  BOOST_TEST(found_later > 30);
  BOOST_TEST(empty > 10);
}

BOOST_AUTO_TEST_CASE(the_most_tolerant_designs_are_the_known_ones) {
  constexpr double known_digits = 5e-9;  // eight decimals are known
  const auto differs = [&](const Problem& problem, double expected) {
    return std::abs(find({problem, {}}, Objective::robust).tolerance - expected);
  };
  BOOST_TEST(differs({1, 1, 0.9, Criterion::published}, 0.36336281) <= known_digits);
  BOOST_TEST(differs({1, 1, 0.9, Criterion::exact}, 0.37608589) <= known_digits);
  BOOST_TEST(differs({1, 1, 0.8, Criterion::published}, 0.22219797) <= known_digits);
  BOOST_TEST(differs({1, 1, 0.8, Criterion::exact}, 0.22219797) <= known_digits);
}

BOOST_AUTO_TEST_CASE(a_single_f_is_left_at_beta_min_and_is_found) {
  RandomSource random(503);
  for (int i = 0; i < 100; ++i) {
    Problem problem = random_problem(random, 1, 2);
    problem.beta = admissible_region(problem).beta_min;
    for (const int ulps : {0, 1}) {
      if (ulps == 1) {
        problem.beta = std::nextafter(problem.beta, HUGE_VAL);
      }
      const Region region = admissible_region(problem);
      for (const Objective objective : objectives) {
        const DesignPoint point = find({problem, {}}, objective);
        check_admissible({problem, {}}, point);
        BOOST_TEST(std::abs(point.f / region.f3 - 1) <= 1e-14);
        BOOST_TEST(point.tolerance <= 1e-14);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(even_thin_strips_are_searched) {
  for (const double f_max : {1e-3, 1e-6, 1e-12}) {
    for (const Criterion criterion : {Criterion::published, Criterion::exact}) {
      for (const Objective objective : objectives) {
        const Task task{{1, 1, 1.1, criterion}, {.f_max = f_max}};
        const DesignPoint point = find(task, objective);
        check_point(task, point);
        if (objective == Objective::robust) {
          // The strip is 2 f_max high at Delta = 1/2: a tolerance of 2 f_max, to first order.
          BOOST_TEST(std::abs(point.tolerance / (2 * f_max) - 1) <= 4 * f_max + 1e-3);
        } else if (objective == Objective::amplitude) {
          BOOST_TEST(point.f >= f_max * (1 - 2e-9));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(a_tolerance_that_the_region_only_just_allows_is_kept_to_the_last_bit) {
  RandomSource random(504);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    Task task = one_hit_task(random);
    task.limits.tolerance = 0.9;  // too much for any region
    for (const Mend& mend : mends(task.problem, task.limits)) {
      if (mend.field != "tolerance" || mend.value == 0) {
        continue;
      }
      task.limits.tolerance = mend.value;
      BOOST_TEST(task.feasible());
      for (const Objective objective : objectives) {
        ++met;
        const DesignPoint point = find(task, objective);
        check_point(task, point, last_digits);
        BOOST_TEST(admissible(task.problem, task.limits, point.f, point.delta));
        BOOST_TEST(point.tolerance >= task.limits.tolerance);
      }
    }
  }
  BOOST_TEST(met > 100);
}

BOOST_AUTO_TEST_SUITE_END()
