// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "scan.hpp"

BOOST_AUTO_TEST_SUITE(search_test)

namespace {

using namespace stillpoint::design_test;

/// Of a cost, relative (of R, absolute): the design stays a relative 1e-9 inside open edges.
constexpr double cost_tolerance = 1e-8;
/// Error in R of the scan of 100 by 100 points, absolute.
constexpr double scan_miss = 0.02;
/// Of the reported R, as in tolerance_test.
constexpr double reported_tolerance = 4e-15;
/// For the largest tolerance that the region allows: the rounding of its edges.
constexpr double last_digits = 2e-15;

Limits make_limits(RandomSource& random, const Problem& problem, int which, bool tolerant) {
  const Region region = admissible_region(problem);
  Limits limits;
  if (which & 1) {
    limits.f_max = region.f3 * random.uniform(0.3, 1.05);
  }
  if (which & 2) {
    limits.delta_max = *region.delta2 * random.uniform(0.2, 1.05);
  }
  limits.tolerance = tolerant ? random.uniform(0.05, 0.2) : 0;
  return limits;
}

DesignPoint find(const Problem& problem, const Limits& limits, Objective objective) {
  const std::optional<SearchResult> result = search(problem, limits, {objective, {}, 20'000, 10});
  BOOST_REQUIRE(result.has_value());
  return result->point;
}

/// The point is admissible with the requested tolerance (minus `doubt`) and reports its own
/// tolerance.
void check_point(const Problem& problem, const Limits& limits, const DesignPoint& point,
                 double doubt = 0) {
  const double asked = std::max(0.0, limits.tolerance - doubt);
  BOOST_TEST(admissible(problem, with_tolerance(limits, asked), point.f, point.delta));
  BOOST_TEST(point.tolerance >= asked);
  for (const Constraint& constraint : constraints(problem, point.f, point.delta)) {
    BOOST_TEST(constraint.satisfied, constraint.name << ": slack " << constraint.slack);
  }
  const auto truth = static_cast<double>(Scan(problem, limits).tolerance(point.f, point.delta));
  BOOST_TEST(std::abs(point.tolerance - truth) <= reported_tolerance,
             point.tolerance << " reported, is " << truth);
}

void check_search(const Problem& problem, const Limits& limits, Objective objective) {
  BOOST_TEST_CONTEXT(name(objective) << ", " << name(problem.criterion) << ", v0 = " << problem.v0
                                     << ", p = " << problem.p << ", beta = " << problem.beta
                                     << ", f_max = " << limits.f_max.value_or(0)
                                     << ", delta_max = " << limits.delta_max.value_or(0)
                                     << ", tolerance = " << limits.tolerance) {
    const DesignPoint point = find(problem, limits, objective);
    check_point(problem, limits, point);
    const Scan scan(problem, limits);
    const auto best = static_cast<double>(scan.least_cost(objective));
    if (objective == Objective::robust) {
      BOOST_TEST(point.tolerance >= -best - cost_tolerance);
      BOOST_TEST(point.tolerance <= -best + scan_miss);
    } else {
      const auto cost = static_cast<double>(scan.cost(objective, point.f));
      BOOST_TEST(cost <= best * (1 + cost_tolerance));
      // Delta is free: no other Delta for this f has more tolerance.
      BOOST_TEST(point.tolerance >=
                 static_cast<double>(scan.best_tolerance(point.f, 400)) - reported_tolerance);
    }
  }
}

DesignPoint robust(const Problem& problem) {
  return find(problem, {}, Objective::robust);
}

}  // namespace

BOOST_AUTO_TEST_CASE(no_point_of_a_dense_scan_is_better_for_any_objective_criterion_and_limit) {
  RandomSource random(501);
  int searched = 0;
  for (int round = 0; round < 12; ++round) {
    for (const Objective objective : objectives) {
      for (const Criterion criterion : {Criterion::published, Criterion::exact}) {
        for (int which = 0; which < 4; ++which) {
          for (const bool tolerant : {false, true}) {
            Problem problem = random_feasible_problem(random);
            problem.criterion = criterion;
            const Limits limits = make_limits(random, problem, which, tolerant);
            if (admissible_region(problem, limits).feasible) {
              ++searched;
              check_search(problem, limits, objective);
            } else {
              BOOST_TEST(Scan(problem, limits).least_cost(Objective::amplitude) == HUGE_VAL);
            }
          }
        }
      }
    }
  }
  BOOST_TEST_MESSAGE(searched << " searched");
  BOOST_TEST(searched > 400);
}

BOOST_AUTO_TEST_CASE(the_most_tolerant_designs_are_the_known_ones) {
  constexpr double known_digits = 5e-9;  // eight decimals are known
  const auto differs = [&](const Problem& problem, double expected) {
    return std::abs(robust(problem).tolerance - expected);
  };
  BOOST_TEST(differs({1, 1, 0.9, Criterion::published}, 0.36336281) <= known_digits);
  BOOST_TEST(differs({1, 1, 0.9, Criterion::exact}, 0.37608589) <= known_digits);
  BOOST_TEST(differs({1, 1, 0.8, Criterion::published}, 0.22219797) <= known_digits);
  BOOST_TEST(differs({1, 1, 0.8, Criterion::exact}, 0.22219797) <= known_digits);
}

BOOST_AUTO_TEST_CASE(the_tolerance_does_not_depend_on_the_scale) {
  RandomSource random(502);
  for (int i = 0; i < 50; ++i) {
    for (const double b : {0.72, 0.8, 0.9, 2.0}) {
      Problem problem = random_problem(random, 1, 2);
      problem.beta = b * problem.v0 / problem.p;
      const double unscaled = robust({1, 1, b, problem.criterion}).tolerance;
      BOOST_TEST(std::abs(robust(problem).tolerance - unscaled) <= cost_tolerance);
    }
  }
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
        const DesignPoint point = find(problem, {}, objective);
        check_point(problem, {}, point);
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
        const Problem problem{1, 1, 1.1, criterion};
        const Limits limits{f_max, std::nullopt, 0};
        const DesignPoint point = find(problem, limits, objective);
        check_point(problem, limits, point);
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
  int not_found = 0;
  int not_withstood = 0;
  int reported_as_less = 0;
  for (int i = 0; i < 200; ++i) {
    const Problem problem = random_feasible_problem(random);
    Limits limits = make_limits(random, problem, random.pick(4), false);
    limits.tolerance = 0.9;  // too much for any region
    for (const Mend& mend : mends(problem, limits)) {
      if (mend.field != "tolerance" || mend.value == 0) {
        continue;
      }
      limits.tolerance = mend.value;
      BOOST_TEST(admissible_region(problem, limits).feasible);
      for (const Objective objective : objectives) {
        ++met;
        const auto result = search(problem, limits, {objective, {}, 20'000, 10});
        if (!result) {
          ++not_found;
          continue;
        }
        const DesignPoint& point = result->point;
        check_point(problem, limits, point, last_digits);
        not_withstood += !admissible(problem, limits, point.f, point.delta);
        reported_as_less += point.tolerance < limits.tolerance;
      }
    }
  }
  BOOST_TEST(met > 100);
  BOOST_TEST(not_found == 0);
  BOOST_TEST(not_withstood == 0);
  BOOST_TEST(reported_as_less == 0);
}

BOOST_AUTO_TEST_SUITE_END()
