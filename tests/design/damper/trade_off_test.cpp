// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "by_map.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(trade_off_test)

// docs/theory.md, "The front". The truth is the motion, a bisection in long double, and brute
// force.

using namespace stillpoint::design_test;

/// Relative, of the motion.
constexpr double formula_tolerance = 1e-14;
/// Of R, absolute: that of the search, as in search_test.
constexpr double tolerance_tolerance = 1e-8;

bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

constexpr std::int64_t count = 7;
constexpr int delta_steps = 200;

BOOST_AUTO_TEST_CASE(
    goes_from_the_largest_stroke_to_the_least_with_the_largest_tolerance_of_each_f) {
  RandomSource random(11);
  int fronts = 0;
  for (int i = 0; i < 150; ++i) {
    const Task task = one_hit_task(random);
    const auto& [problem, limits, seed] = task;
    const auto front = trade_off(problem, limits, count);
    BOOST_TEST(front.empty() == !admissible_region(problem, limits).feasible);
    fronts += front.empty() ? 0 : 1;
    for (std::size_t k = 0; k < front.size(); ++k) {
      const auto& [damper, peak, acceleration, stop_time] = front[k];
      const auto& [f, delta, tolerance] = damper;
      BOOST_TEST(admissible(problem, limits, f, delta));
      BOOST_TEST(admissible(problem, with_tolerance(limits, tolerance), f, delta));
      BOOST_TEST(tolerance >= limits.tolerance);
      // Peak and S depend on f alone, so no damper with another f is as good in both, and none is
      // better than one of the front.
      BOOST_TEST(std::abs(by_map::tolerance(task, f, delta) - tolerance) <= tolerance_tolerance);
      for (int j = 1; j <= delta_steps; ++j) {
        const double other = problem.v0 * problem.v0 / 2 * j / delta_steps;
        BOOST_TEST(by_map::tolerance(task, f, other, tolerance + tolerance_tolerance) < 0);
      }
      const Response motion = free_response({problem.p, f, delta}, {0, problem.v0});
      BOOST_TEST(near(peak, motion.peak_amplitude, formula_tolerance));
      BOOST_TEST(near(acceleration, motion.peak_absolute_acceleration, formula_tolerance));
      BOOST_TEST(stop_time * problem.p > 3.14);
      BOOST_TEST((k == 0 || damper.f > front[k - 1].damper.f));
      BOOST_TEST((k == 0 || peak < front[k - 1].peak_amplitude));
      BOOST_TEST((k == 0 || acceleration > front[k - 1].transmitted));
    }
  }
  BOOST_TEST(fronts > 75);
}

/// At the last f the return leaves a tolerance of next to nothing, and all of Delta1 to Delta2 has
/// it.
BOOST_AUTO_TEST_CASE(of_equally_tolerant_delta_it_has_the_middle) {
  const Problem problem{1, 1, 0.9};
  const DesignPoint last = trade_off_at(problem, {}, count, count).value();
  const double middle = (delta1_published(problem, last.f) + 0.5) / 2;
  BOOST_TEST(near(last.delta, middle, 1e-8));
}

BOOST_AUTO_TEST_CASE(has_no_damper_more_tolerant_than_the_robust_design_and_comes_close) {
  RandomSource random(14);
  for (int i = 0; i < 20; ++i) {
    const auto [problem, limits, seed] = one_hit_task(random);
    const auto front = trade_off(problem, limits, 41);
    const auto robust = search(problem, limits);
    BOOST_TEST(front.empty() == !robust);
    double most = 0;
    for (const TradeOff& now : front) {
      most = std::max(most, now.damper.tolerance);
    }
    BOOST_TEST((!robust || most <= robust->point.tolerance + tolerance_tolerance));
    // R falls from its maximum by at most the change of f over f, a fortieth of the span.
    BOOST_TEST((!robust || most >= robust->point.tolerance - 0.06));
  }
}

BOOST_AUTO_TEST_CASE(leaves_out_the_f_between_two_strips) {
  // Beta not binding and +-30 %: the first arrival wants f = 0.26 or so, the second f < 0.06; or
  // beta leaves the second one f > 0.03.
  for (const auto& [beta, tolerance] : {std::pair{1.2, 0.3}, std::pair{0.98, 0.3}}) {
    Problem problem{1, 1, beta, Criterion::exact, 2};
    const auto front = trade_off(problem, {.tolerance = tolerance}, 21);
    BOOST_TEST(front.size() == 21U);
    const auto own = strips(problem, {.tolerance = tolerance});
    BOOST_TEST_REQUIRE(own.size() == 2U);
    BOOST_TEST_REQUIRE(*own[1].f_upper < *own[0].f_lower);
    std::size_t of_each[2]{};
    for (const TradeOff& now : front) {
      const bool first = now.damper.f >= *own[0].f_lower && now.damper.f <= *own[0].f_upper;
      const bool second = now.damper.f >= *own[1].f_lower && now.damper.f <= *own[1].f_upper;
      BOOST_TEST((first || second));
      ++of_each[first ? 0 : 1];
    }
    BOOST_TEST(of_each[0] > 2U);
    BOOST_TEST(of_each[1] > 2U);
  }
}

BOOST_AUTO_TEST_CASE(of_a_single_f_is_one_damper_and_of_none_is_empty) {
  const double least = admissible_region({1, 1, 1}).beta_min;
  const auto one = trade_off({1, 1, least}, {}, 5);
  BOOST_TEST(one.size() == 1U);
  BOOST_TEST(trade_off({1, 1, 0.5}, {}, 5).empty());
}

BOOST_AUTO_TEST_CASE(refuses_a_wrong_count) {
  for (const std::int64_t wrong : {std::int64_t{-1}, std::int64_t{0}, std::int64_t{1},
                                   std::int64_t{1001}, std::int64_t{1'000'000'000}}) {
    BOOST_TEST(refusal_of<InputError>([&] {
                 return trade_off({1, 1, 1}, {}, wrong);
               }) ==
               "trade_off = " + std::to_string(wrong) + ": must be a whole number from 2 to 1000");
  }
  BOOST_TEST(trade_off({1, 1, 1}, {}, 2).size() == 2U);
}

BOOST_AUTO_TEST_SUITE_END()
