// SPDX-License-Identifier: MIT
#include "damper.hpp"

#include <stillpoint/design/tolerance.hpp>

BOOST_AUTO_TEST_SUITE(tolerance_test)

namespace {

using namespace stillpoint::design_test;

/// Of R: relative where it is large, absolute where f and Delta themselves are rounded.
constexpr double r_relative = 1e-9;
constexpr double r_absolute = 2e-15;

Limits random_limits(RandomSource& random, const Region& region) {
  Limits limits;
  random.one_in(2, limits.f_max, [&] { return region.f3 * random.uniform(0.3, 1.1); });
  random.one_in(2, limits.delta_max, [&] { return *region.delta2 * random.uniform(0.3, 1.1); });
  random.one_in(3, limits.acceleration_max,
                [&] { return std::sqrt(8.0) * region.f3 * random.uniform(1, 1.1); });
  return limits;
}

/// The box is admissible at r, and not beyond it.
void check_largest(const Reference& reference, const Limits& limits, const DesignPoint& at) {
  const Precise inner = Precise(at.tolerance) * (1 - r_relative) - r_absolute;
  const Precise outer = Precise(at.tolerance) * (1 + r_relative) + r_absolute;
  BOOST_TEST((inner < 0 || reference.box_admissible(limits, at.f, at.delta, inner)));
  BOOST_TEST(!reference.box_admissible(limits, at.f, at.delta, outer), "r = " << at.tolerance);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_box_is_admissible_at_the_largest_tolerance_and_not_beyond) {
  RandomSource random(401);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Problem problem = random_feasible_problem(random);
    const Region region = admissible_region(problem);
    const Limits limits = random_limits(random, region);
    const double f = region.f3 * random.uniform(0, 1);
    const double delta = *region.delta2 * random.uniform(0, 1);
    const Reference reference(problem);
    const std::optional<double> r = largest_tolerance(problem, limits, f, delta);
    BOOST_TEST(r.has_value() == reference.box_admissible(limits, f, delta, 0));
    if (!r) {
      continue;
    }
    ++met;
    BOOST_TEST(admissible(problem, with_tolerance(limits, *r), f, delta));
    check_largest(reference, limits, {f, delta, *r});
  }
  BOOST_TEST(met > 300);
}

BOOST_AUTO_TEST_CASE(near_every_edge_the_tolerance_is_the_distance_to_it) {
  RandomSource random(402);
  for (int i = 0; i < 2000; ++i) {
    const Problem problem = random_problem(random, 0.75, 0.95);
    const Reference reference(problem);
    const Region region = admissible_region(problem);
    const double distance = random.log_uniform(1e-12, 1e-3);
    double f = region.f2 + (region.f3 - region.f2) * random.uniform(0.2, 0.8);
    const double lowest = delta1(problem, f).value();
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
    const std::optional<double> r = largest_tolerance(problem, {}, f, delta);
    BOOST_REQUIRE(r.has_value());
    check_largest(reference, {}, {f, delta, *r});
  }
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
