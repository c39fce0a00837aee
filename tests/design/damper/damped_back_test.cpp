// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "way/unit_strip.hpp"

BOOST_AUTO_TEST_SUITE(damped_back_test)

// Half-cycles with damping, followed back from an edge, against the motions of the kernel.

using namespace stillpoint::design_test;

/// Of V0, by which a motion is on one side of an edge: a few roundings of every half-cycle.
constexpr double aside = 1e-12;
/// Relative, of slopes taken as differences.
constexpr double of_slopes = 1e-6;
/// Relative, of the acceleration.
constexpr double rounding = 1e-14;

/// A random task of n arrivals with V0 = p = 1 in the end.
struct Drawn {
  double zeta;
  double a;
  double d;
  int n;
};

Drawn drawn(RandomSource& random) {
  return {random.log_uniform(1e-9, 0.9), random.log_uniform(1e-4, 3), random.log_uniform(1e-4, 3),
          1 + static_cast<int>(random.pick(4))};
}

Response motion_of(const Drawn& now, double square, double part) {
  return free_response({1, now.a, now.d, {}, now.zeta}, {0, std::sqrt(square) * part});
}

BOOST_AUTO_TEST_CASE(the_weakest_hits_that_reach_and_that_pass_an_arrival) {
  RandomSource random(5121);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const Drawn now = drawn(random);
    const double turn = now.a * (2 + unit::shrinks_by(now.zeta));
    const double reaches =
        unit::followed_back({turn, 0, now.a, 1, now.zeta}, now.n - 1, now.d).square;
    const double passes = unit::followed_back({now.a, 1, now.a, 1, now.zeta}, now.n, now.d).square;
    BOOST_TEST_CONTEXT("zeta " << now.zeta << ", a " << now.a << ", d " << now.d) {
      BOOST_TEST(motion_of(now, passes, 1 - aside).half_cycles == now.n);
      BOOST_TEST(motion_of(now, passes, 1 + aside).half_cycles == now.n + 1);
      if (reaches * (1 - aside) > 2 * now.d) {  // the notch does not hold it
        ++seen;
        const Response beside = motion_of(now, reaches, 1 - aside);
        BOOST_TEST(beside.half_cycles == now.n);
        BOOST_TEST((beside.outcome == Outcome::stopped_in_dead_zone));
        BOOST_TEST((motion_of(now, reaches, 1 + aside).outcome == Outcome::stopped_at_zero));
      }
    }
  }
  BOOST_TEST(seen > 150);
}

BOOST_AUTO_TEST_CASE(slopes_are_those_of_differences) {
  RandomSource random(5122);
  for (int i = 0; i < 300; ++i) {
    const auto [zeta, a, d, n] = drawn(random);
    const auto at = [&, zeta = zeta, n = n](double at_a, double at_d) {
      return unit::followed_back({2 * at_a, 2, at_a, 1, zeta}, n, at_d);
    };
    const unit::EdgeSpeed now = at(a, d);
    constexpr double step = 1e-5;
    const double by_a =
        (at(a * (1 + step), d).square - at(a * (1 - step), d).square) / 2 / step / a;
    const double by_d =
        (at(a, d * (1 + step)).square - at(a, d * (1 - step)).square) / 2 / step / d;
    BOOST_TEST(std::abs(now.by_a - by_a) <= of_slopes * (by_a + now.square / a));
    BOOST_TEST(std::abs(now.by_d - by_d) <= of_slopes * (by_d + now.square / d));
  }
}

BOOST_AUTO_TEST_CASE(hardly_any_damping_is_none) {
  constexpr double zeta = 1e-13;
  const unit::EdgeStart start{0.7, 2, 0.3, 1};
  const unit::EdgeStart damped{0.7, 2, 0.3, 1, zeta};
  const unit::EdgeSpeed without = unit::followed_back(start, 3, 0.1);
  const unit::EdgeSpeed with = unit::followed_back(damped, 3, 0.1);
  constexpr double close = 1e-11;
  BOOST_TEST(std::abs(with.square / without.square - 1) <= close);
  BOOST_TEST(std::abs(with.by_a / without.by_a - 1) <= close);
  BOOST_TEST(std::abs(with.by_d / without.by_d - 1) <= close);
}

BOOST_AUTO_TEST_CASE(the_structure_feels_what_it_does_in_the_motion) {
  RandomSource random(5123);
  for (int i = 0; i < 300; ++i) {
    const double zeta = random.log_uniform(1e-6, 0.9);
    const double a = random.log_uniform(1e-6, 10);
    const Response motion = free_response({1, a, 0.1, {}, zeta}, {0, 1});
    BOOST_TEST(std::abs(unit::damped_acceleration(zeta, a) / motion.peak_absolute_acceleration -
                        1) <= rounding);
  }
}

BOOST_AUTO_TEST_CASE(the_structure_feels_the_most_at_an_end_of_a_range_of_damping) {
  RandomSource random(5124);
  for (int i = 0; i < 5000; ++i) {
    const double a = random.pick(10) == 0 ? 0 : random.log_uniform(1e-4, 10);
    const double low = random.uniform(0, 0.9);
    const double high = random.uniform(low, 0.9);
    const double most =
        std::max(unit::damped_acceleration(low, a), unit::damped_acceleration(high, a));
    BOOST_TEST(unit::damped_acceleration(random.uniform(low, high), a) <= most * (1 + rounding));
  }
}

BOOST_AUTO_TEST_SUITE_END()
