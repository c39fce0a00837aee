// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(acceleration_limit_test)

using namespace stillpoint::design_test;

/// Of S, relative: f4 is rounded inwards once, from inputs that are taken as decimals where they
/// would leave rounding alone.
constexpr double s_tolerance = 1e-15;

Limits at_most(double acceleration, double tolerance = 0) {
  return {.tolerance = tolerance, .acceleration_max = acceleration};
}

BOOST_AUTO_TEST_CASE(f4_is_where_s_meets_the_limit) {
  RandomSource random(2501);
  for (int i = 0; i < 1000; ++i) {
    const Problem problem = random_problem(random, 0.3, 3);
    const double limit = problem.v0 * problem.p * (1 + random.log_uniform(1e-12, 10));
    const Region region = admissible_region(problem, at_most(limit));
    BOOST_TEST_REQUIRE(region.f4.has_value());
    BOOST_TEST(close(limit, Reference(problem).s(*region.f4), s_tolerance));
    BOOST_TEST(Reference(problem).s(*region.f4) <= Precise(limit) * (1 + s_tolerance));
    // It is the only change to the rows.
    const auto rows = constraints(problem, at_most(limit), region.f3 / 2, *region.delta2 / 2);
    BOOST_TEST(rows.size() == 6U);
    BOOST_TEST(rows.back().name == "acceleration");
    BOOST_TEST(rows.back().limit == *region.f4);
    BOOST_TEST(rows.back().satisfied == (region.f3 / 2 <= *region.f4));
  }
  BOOST_TEST(!admissible_region({1, 1, 1}).f4.has_value());
}

BOOST_AUTO_TEST_CASE(no_friction_is_small_enough_where_the_spring_alone_exceeds_the_limit) {
  const Problem problem{13, 1, 30};
  const Limits limits = at_most(12);
  const Region region = admissible_region(problem, limits);
  BOOST_TEST(!region.feasible);
  BOOST_TEST((region.conflict == Conflict::limit_alone));
  BOOST_TEST(region.limit->field == "acceleration_max");
  BOOST_TEST(*region.f4 == -5);
  BOOST_TEST((reason(region, problem, limits)
                  ->find("even without friction the transmitted acceleration is 13 g, above the "
                         "limit of 12 g") != std::string::npos));
  // Of springs with p of 12 to 13, the stiffest decides.
  const Problem springs{.v0 = 1, .p = 12, .beta = 30, .p_high = 13};
  const auto of_stiffest =
      reason(admissible_region(springs, at_most(12.5)), springs, at_most(12.5));
  BOOST_TEST((of_stiffest->find("is 13 g, above the limit of 12.5 g") != std::string::npos),
             *of_stiffest);
  BOOST_TEST(!constraints(problem, limits, 0, 50).back().satisfied);
  BOOST_TEST(!largest_tolerance(problem, limits, 1, 80));
  // At equality S = A needs f = 0, which leaves no Delta.
  const Region touching = admissible_region(problem, at_most(13));
  BOOST_TEST((touching.conflict == Conflict::stop_against_start));
  const DesignResult none = design::design({problem, limits});
  BOOST_TEST(!none.finding);
  BOOST_TEST(none.mends.size() == 3U);  // v0, p, acceleration_max
}

BOOST_AUTO_TEST_CASE(amplitude_and_acceleration_may_conflict) {
  // f2 = 7 with V0 = 24, p = 1, beta = 18; A = 24.5: f4^2 = 24.25.
  const Problem problem{24, 1, 18};
  const Region region = admissible_region(problem, at_most(24.5));
  BOOST_TEST((region.conflict == Conflict::amplitude_against_limit));
  BOOST_TEST(region.limit->field == "acceleration_max");
  BOOST_TEST((
      reason(region, problem, at_most(24.5))
          ->find("needs f >= 7, but a transmitted acceleration within 24.5 g needs f <= 4.92442") !=
      std::string::npos));
  BOOST_TEST(admissible_region(problem, at_most(25)).feasible);  // 7-24-25
  BOOST_TEST(!admissible_region(problem, at_most(25, 1e-9)).feasible);
  const auto list = mends(problem, at_most(24.5));
  const auto limit = std::ranges::find(list, "acceleration_max", &Mend::field);
  BOOST_TEST_REQUIRE((limit != list.end()));
  BOOST_TEST(std::abs(limit->value - 25) < 1e-14);
}

BOOST_AUTO_TEST_SUITE_END()
