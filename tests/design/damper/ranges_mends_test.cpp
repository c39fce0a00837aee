// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(ranges_mends_test)

// What would help if no damper serves the ranges or has the tolerance.

using namespace stillpoint::design_test;

BOOST_AUTO_TEST_CASE(an_unattainable_tolerance_is_reported_with_the_largest_one) {
  constexpr double more =
      1e-7;  // relative, of the largest tolerance: its search, and that of a box
  constexpr int points = 100;
  int at_fault = 0;
  int not_at_fault = 0;
  for (int i = 0; i < 300; ++i) {
    RandomSource random(1'207'000 + static_cast<std::uint64_t>(i));
    Task task = any_task(random);
    Problem& problem = task.problem;
    Limits& limits = task.limits;
    problem.beta *= 0.95;
    limits.tolerance = random.uniform(0.05, 0.9);
    const auto region_with = [&](double tolerance) {
      return admissible_region(problem, with_tolerance(limits, tolerance)).feasible;
    };
    const auto most = answer({problem, limits, {}, {}}).most_tolerant;
    BOOST_TEST_CONTEXT(context_of(task)) {
      BOOST_TEST(most.has_value() == (!region_with(limits.tolerance) && region_with(0)));
      if (!most) {
        ++not_at_fault;
        continue;
      }
      ++at_fault;
      const auto& [f, delta, tolerance] = *most;
      BOOST_TEST(tolerance < limits.tolerance);
      BOOST_TEST(admissible(problem, with_tolerance(limits, tolerance), f, delta));
      BOOST_TEST(!region_with(tolerance * (1 + more)));
      for (int k = 0; k < points; ++k) {
        const auto other = largest_tolerance(
            problem, limits, problem.v0 * problem.p * random.log_uniform(0.003, 0.4),
            problem.v0 * problem.v0 * random.uniform(0, 0.5));
        BOOST_TEST(other.value_or(0) <= tolerance * (1 + more));
      }
    }
  }
  BOOST_TEST(at_fault > 100);
  BOOST_TEST(not_at_fault > 50);
}

// The tip of the first strip, where the mass rests r before x = 0, is where 8 f^2 = 1 + 6 r f - r^2
// (V0 = p = 1). Its f over 1 + R and f2 over 1 - R leave a part of 1e-10 here: far more than
// rounding.
BOOST_AUTO_TEST_CASE(a_narrow_interval_of_f_below_a_tip_has_a_damper) {
  constexpr double tolerance = 0.1;
  constexpr double beyond = 1e-10;
  for (int i = 0; i < 50; ++i) {
    const double r = 0.01 + 1e-4 * i;
    const double tip = (3 * r + std::sqrt(r * r + 8)) / 8;
    const double f2 = tip * (1 - tolerance) / (1 + tolerance);
    const double beta = std::hypot(f2, 1) - f2;
    for (const double part : {-beyond, beyond}) {
      Problem problem{1, 1, beta * (1 + part)};
      problem.residual = r;
      BOOST_TEST(admissible_region(problem, {.tolerance = tolerance}).feasible == (part > 0));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
