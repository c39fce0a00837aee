// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(region_test)

using namespace stillpoint::design_test;

/// Of f1: a few roundings to nearest.
constexpr double edge_tolerance = 3.4e-16;
/// Of Delta1, relative to V0^2: the error of f/(V0 p) reaches it at a slope of -2.
constexpr double delta1_tolerance = 1e-15;

constexpr int problems = 4000;

/// Nine decades of each of the three on its own.
Problem any_problem(RandomSource& random) {
  return {random.log_uniform(3e-5, 3e4), random.log_uniform(3e-5, 3e4),
          random.log_uniform(3e-5, 3e4), Criterion::published};
}

Constraint named(const Problem& problem, double f, double delta, std::string_view name) {
  for (const Constraint& constraint : constraints(problem, f, delta)) {
    if (constraint.name == name) {
      return constraint;
    }
  }
  throw std::logic_error("no such constraint");
}

BOOST_AUTO_TEST_CASE(the_edges_of_f_are_rounded_inwards_and_no_further) {
  constexpr double doubt = 1e-18;  // of long double, relative to V0^2/(2 beta) and to f3
  RandomSource random(108);
  for (int i = 0; i < problems; ++i) {
    const Problem problem = random_problem(random, 0.1, 3);
    const Reference reference(problem);
    const Region region = admissible_region(problem);
    BOOST_TEST(close(region.f1, reference.f1(), edge_tolerance));
    const Precise f2_doubt = doubt * Precise(problem.v0) * problem.v0 / (2 * Precise(problem.beta));
    const Precise f3_doubt = doubt * reference.f3();
    BOOST_TEST((Precise(region.f2) >= reference.f2() - f2_doubt));
    BOOST_TEST((Precise(std::nextafter(region.f2, -HUGE_VAL)) <= reference.f2() + f2_doubt));
    BOOST_TEST((Precise(region.f3) <= reference.f3() + f3_doubt));
    BOOST_TEST((Precise(std::nextafter(region.f3, HUGE_VAL)) >= reference.f3() - f3_doubt));
    if (region.f2 > 0 && region.feasible) {
      const auto admits = [&](double f) { return admissible(problem, {}, f, *region.delta2); };
      BOOST_TEST((admits(region.f2) && !admits(std::nextafter(region.f2, 0))));
      BOOST_TEST((admits(region.f3) && !admits(std::nextafter(region.f3, HUGE_VAL))));
    }
  }
}

/// Towards f3 the exact one vanishes like f3 - f: its relative error is that of f over the
/// distance.
BOOST_AUTO_TEST_CASE(both_lower_bounds_of_delta_are_their_formulas_over_nine_decades) {
  RandomSource random(102);
  for (int i = 0; i < problems; ++i) {
    const Problem problem = any_problem(random);
    const Reference reference(problem);
    const double f3 = admissible_region(problem).f3;
    const double distance =
        random.pick(2) == 0 ? random.uniform(0, 1) : random.log_uniform(1e-12, 0.5);
    const double f = f3 * (1 - distance);
    const Precise bound = Precise(delta1_tolerance) * problem.v0 * problem.v0;
    BOOST_TEST(within(delta1_published(problem, f), reference.delta1_published(f), bound));
    BOOST_TEST(within(delta1_exact(problem, f).value(), reference.delta1_exact(f), bound));
    BOOST_TEST(close(delta1_exact(problem, f).value(), reference.delta1_exact(f),
                     1e-15 + 3e-16 / distance));
  }
}

BOOST_AUTO_TEST_CASE(every_slack_is_positive_inside_and_negative_outside) {
  const Problem problem{1, 1, 0.9};  // f2 = 0.1056, f3 = 0.3536, Delta1(0.2) = 0.1922
  for (const Constraint& constraint : constraints(problem, 0.2, 0.3)) {
    BOOST_TEST(constraint.satisfied);
    BOOST_TEST(constraint.slack > 0);
    BOOST_TEST(std::abs(constraint.value - constraint.limit) == constraint.slack);
  }
  const auto violated = [&](std::string_view name, double f, double delta) {
    const Constraint constraint = named(problem, f, delta, name);
    BOOST_TEST(!constraint.satisfied);
    BOOST_TEST(constraint.slack < 0);
    BOOST_TEST(std::abs(constraint.value - constraint.limit) == -constraint.slack);
  };
  violated("dead_zone", 0.95, 0.3);
  violated("start", 0.2, 0.55);
  violated("amplitude", 0.1, 0.4);
  violated("return", 0.36, 0.3);
  violated("stop", 0.2, 0.19);
  // dead_zone and stop are strict.
  const double f1 = admissible_region(problem).f1;
  BOOST_TEST(named(problem, std::nextafter(f1, 0), 0.3, "dead_zone").satisfied);
  BOOST_TEST(!named(problem, f1, 0.3, "dead_zone").satisfied);
  const Constraint stop = named(problem, 0.2, delta1_published(problem, 0.2), "stop");
  BOOST_TEST((!stop.satisfied && stop.slack == 0));
}

BOOST_AUTO_TEST_CASE(the_constraints_come_in_the_promised_order_with_their_relations) {
  const auto list = constraints({1, 1, 0.9}, 0.2, 0.3);
  using Pair = std::pair<std::string_view, std::string_view>;
  const std::array<Pair, 5> expected{Pair{"dead_zone", "<"}, Pair{"start", "<="},
                                     Pair{"amplitude", ">="}, Pair{"return", "<="},
                                     Pair{"stop", ">"}};
  for (std::size_t i = 0; i < list.size(); ++i) {
    BOOST_TEST(list[i].name == expected[i].first);
    BOOST_TEST(list[i].relation == expected[i].second);
  }
}

// (28) and (29): of a box whose low corner needs the largest Delta that its high one may have.
BOOST_AUTO_TEST_CASE(the_least_f_within_a_largest_delta_inverts_the_bound) {
  constexpr double root_of_the_search = 1e-13;
  RandomSource random(110);
  for (int i = 0; i < problems; ++i) {
    Problem problem = any_problem(random);
    problem.beta = 2 * problem.v0 / problem.p;  // f2 < 0
    problem.criterion = i % 2 == 0 ? Criterion::published : Criterion::exact;
    const double allowed = random.uniform(0.1, 0.45);
    const double t = random.uniform(0, 0.1);
    const double d = allowed * (1 - t) / (1 + t);
    const double a = i % 2 == 0 ? (1 - 2 * d) / (2 * std::sqrt(2 * d) + std::sqrt(3 + 2 * d))
                                : (1 - 2 * d) / std::sqrt(8 * (1 + 2 * d));
    if (a * (1 + t) / (1 - t) < 1 / std::sqrt(8.0)) {
      const Region region = admissible_region(
          problem, {.delta_max = allowed * problem.v0 * problem.v0, .tolerance = t});
      BOOST_REQUIRE(region.feasible);
      BOOST_TEST(close(*region.f_lower, a * problem.v0 * problem.p / (1 - t), root_of_the_search));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
