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

struct Optimum {
  double f{0};
  double delta{0};
  double r{-1};
};

/// The box is admissible at r, and not beyond it.
void check_largest(const Reference& reference, const Limits& limits, const Optimum& at) {
  const Precise inner = Precise(at.r) * (1 - r_relative) - r_absolute;
  const Precise outer = Precise(at.r) * (1 + r_relative) + r_absolute;
  BOOST_TEST((inner < 0 || reference.box_admissible(limits, at.f, at.delta, inner)));
  BOOST_TEST(!reference.box_admissible(limits, at.f, at.delta, outer), "r = " << at.r);
}

/// The most tolerant point by a grid, which is then laid again around its best point, finer.
Optimum most_tolerant(const Problem& problem) {
  const Region region = admissible_region(problem);
  Optimum best;
  double f_width = region.f3;
  double delta_width = *region.delta2;
  Optimum centre{region.f3 / 2, *region.delta2 / 2, -1};
  for (int round = 0; round < 40; ++round) {
    for (int i = -10; i <= 10; ++i) {
      for (int j = -10; j <= 10; ++j) {
        const double f = centre.f + f_width * i / 10;
        const double delta = centre.delta + delta_width * j / 10;
        if (f <= 0 || delta <= 0) {
          continue;
        }
        const double r = largest_tolerance(problem, {}, f, delta).value_or(-1);
        if (r > best.r) {
          best = {f, delta, r};
        }
      }
    }
    centre = best;
    f_width *= 0.6;
    delta_width *= 0.6;
  }
  return best;
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

BOOST_AUTO_TEST_CASE(a_tolerance_worked_out_by_hand) {
  // f = 0.25 lies as far below f_max = 0.3 as the box may reach: 20 %. Delta = 0.4 allows 25 %.
  const Problem problem{1, 1, 2};
  const auto r = [&](const Limits& limits, double f, double delta) {
    return largest_tolerance(problem, limits, f, delta).value_or(-1);
  };
  BOOST_TEST(std::abs(r({0.3, std::nullopt, 0}, 0.25, 0.4) - 0.2) < 1e-15);
  BOOST_TEST(std::abs(r({std::nullopt, 0.44, 0}, 0.25, 0.4) - 0.1) < 1e-15);
  BOOST_TEST(std::abs(r({}, 0.25, 0.4) - 0.25) < 1e-15);
  BOOST_TEST(r({0.2, std::nullopt, 0}, 0.25, 0.4) == -1);
  BOOST_TEST(r({std::nullopt, 0.35, 0}, 0.25, 0.4) == -1);
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

BOOST_AUTO_TEST_CASE(the_most_tolerant_point_is_universal_where_amplitude_does_not_bind) {
  constexpr double digits = 5e-5;  // four digits are known
  struct Known {
    Criterion criterion;
    double f, delta, r;
  };
  for (const Known& known : {Known{Criterion::published, 0.2593, 0.3667, 0.36336281},
                             Known{Criterion::exact, 0.2569, 0.3633, 0.37608589}}) {
    for (const auto& [v0, p] : {std::pair{1.0, 1.0}, {3e4, 2e-3}, {5e-4, 7.0}}) {
      const Optimum best = most_tolerant({v0, p, 1.1 * v0 / p, known.criterion});
      BOOST_TEST(std::abs(best.f / (v0 * p) - known.f) < digits);
      BOOST_TEST(std::abs(best.delta / (v0 * v0) - known.delta) < digits);
      BOOST_TEST(std::abs(best.r - known.r) < 1e-7);
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
