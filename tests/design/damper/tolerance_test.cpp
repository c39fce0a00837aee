// SPDX-License-Identifier: MIT
#include "any_task.hpp"
#include "by_map.hpp"
#include "damper.hpp"

#include <stillpoint/design/tolerance.hpp>

BOOST_AUTO_TEST_SUITE(tolerance_test)

using namespace stillpoint::design_test;

/// Of R: f and Delta themselves are rounded.
constexpr double rounding = 4e-15;

/// And of the motion; the published criterion admits less.
BOOST_AUTO_TEST_CASE(the_largest_tolerance_of_any_point_is_that_of_the_map) {
  RandomSource random(401);
  int met = 0;
  int later = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Task task = one_hit_task(random);
    const auto& [problem, limits, seed] = task;
    const double f = problem.v0 * problem.p * random.log_uniform(1e-3, 0.4);
    const double delta = problem.v0 * problem.v0 * random.uniform(0, 0.5);
    const std::optional<double> r = largest_tolerance(problem, limits, f, delta);
    BOOST_TEST_CONTEXT("point " << i << ": f = " << f << ", delta = " << delta << ", "
                                << context_of(task)) {
      BOOST_TEST(std::abs(r.value_or(-1) - by_map::tolerance(task, f, delta)) <= rounding);
      BOOST_TEST((!r || admissible(problem, with_tolerance(limits, *r), f, delta)));
      BOOST_TEST((!r || arrival_of(problem, f, delta) == by_map::arrival(problem, f, delta)));
      const Verdict seen = simulated(task, {f, delta, problem.v0, problem.p});
      BOOST_TEST((problem.criterion == Criterion::published
                      ? !r || seen == Verdict::good
                      : seen != (r ? Verdict::bad : Verdict::good)));
    }
    met += r.has_value();
    later += r && arrival_of(problem, f, delta).value() > 1;
  }
  BOOST_TEST(met > 2000);
  BOOST_TEST(later > 500);
}

/// Beyond it there is none.
BOOST_AUTO_TEST_CASE(near_every_edge_the_tolerance_is_the_distance_to_it) {
  RandomSource random(402);
  int beyond = 0;
  for (int i = 0; i < 4000; ++i) {
    const Task task{random_problem(random, 0.75, 0.95), {}};
    const Region region = admissible_region(task.problem);
    const double distance = (i % 2 == 0 ? 1 : -1) * random.log_uniform(1e-12, 1e-3);
    double f = region.f2 + (region.f3 - region.f2) * random.uniform(0.2, 0.8);
    const double lowest = delta1(task.problem, f).value();
    double delta = lowest + (*region.delta2 - lowest) * 0.5;
    switch (random.pick(4)) {
      case 0:
        f = region.f2 / (1 - distance);
        delta = *region.delta2 * 0.95;
        break;
      case 1:
        f = region.f3 / (1 + distance);
        break;
      case 2:
        delta = *region.delta2 / (1 + distance);
        break;
      default:
        delta = lowest * (1 + distance);
        break;
    }
    const double r = largest_tolerance(task.problem, {}, f, delta).value_or(-1);
    BOOST_TEST(std::abs(r - by_map::tolerance(task, f, delta)) <= rounding);
    beyond += r < 0;
  }
  BOOST_TEST(beyond == 2000);
}

BOOST_AUTO_TEST_CASE(any_friction_up_to_that_is_admissible_and_none_beyond) {
  // Points of the box are admissible; a little farther out one of its two corners is not.
  RandomSource random(2611);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const double v0 = random.uniform(0.5, 2);
    const double p = random.uniform(0.5, 2);
    Problem problem{v0, p, v0 / p * random.uniform(1, 1.2)};
    problem.arrivals = 2;
    Limits limits;
    random.one_in(2, limits.f_max, [&] { return v0 * p * random.log_uniform(1e-3, 0.3); });
    const double delta = v0 * v0 * random.uniform(0.26, 0.49);
    const double r = random.uniform(0, 0.3);
    const auto largest = any_f_up_to(problem, limits, delta, r);
    const double error = 1e-6 * v0 * p;  // that it may have, and more than the box leaves out
    const auto works = [&](double f, double with) { return admissible(problem, limits, f, with); };
    if (!largest) {
      BOOST_TEST(!(works(error, delta * (1 - r)) && works(error, delta * (1 + r))));
      continue;
    }
    ++found;
    for (int j = 0; j < 50; ++j) {
      BOOST_TEST(
          works(*largest * random.uniform(1e-3, 1), delta * (1 + r * random.uniform(-1, 1))));
    }
    const double beyond = *largest + error;
    BOOST_TEST(!(works(beyond, delta * (1 - r)) && works(beyond, delta * (1 + r))));
  }
  BOOST_TEST(found > 50);
}

BOOST_AUTO_TEST_CASE(on_an_edge_no_tolerance_is_left) {
  const Problem problem{24, 1, 18};  // f2 = 7
  BOOST_TEST(largest_tolerance(problem, {}, 7, 200).value() == 0);
  BOOST_TEST(largest_tolerance(problem, {}, 7.5, 288).value() == 0);
  BOOST_TEST(largest_tolerance(problem, {}, admissible_region(problem).f3, 200).value() == 0);
  BOOST_TEST(!largest_tolerance(problem, {}, 6.9, 200));
}

BOOST_AUTO_TEST_SUITE_END()
