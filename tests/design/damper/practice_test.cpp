// SPDX-License-Identifier: MIT
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(practice_test)

using namespace stillpoint::design_test;

/// A few roundings, and those of the motion's arrival speed.
constexpr double tolerance = 1e-13;

void check_close(const std::optional<double>& value, double expected) {
  BOOST_TEST_REQUIRE(value.has_value());
  BOOST_TEST(std::abs(*value - expected) <= tolerance * std::abs(expected),
             *value << " instead of " << expected);
}

std::optional<Practice> of(const Oscillator& oscillator, double v0,
                           const std::optional<double>& limit = {}) {
  return practice(oscillator, free_response(oscillator, {0, v0}), limit);
}

BOOST_AUTO_TEST_CASE(by_hand) {
  // f = 1, p = 2, V0 = sqrt(6): phi = 0.5, S = 2.5, so A = 2/p and w^2 = (S - phi)(S - 3 phi) = 2.
  // Delta = 2.5 holds it.
  const Practice lines = of({2, 1, 2.5}, std::sqrt(6.0), 9).value();
  check_close(lines.base_shear, 5);
  check_close(lines.restoring, 4);
  check_close(lines.secant_stiffness, 5);
  check_close(lines.energy_ratio, 2);
  check_close(lines.residual_ratio, 4);
  check_close(lines.impulse_at_stop, std::sqrt(2.0));
  check_close(lines.impulse_largest, std::sqrt(2.0));
  check_close(lines.notch_used, 0.4);
  BOOST_TEST(lines.notch_capacity == 2.5);
  check_close(lines.notch_width_min, 2.5 / (std::sqrt(83.0) - 1));  // 9^2 + p^2 (2.5 - 2)
  // (4 f A + 2 Delta)/(4 pi 1/2 5 A) = 9/(10 pi).
  check_close(lines.equivalent_damping, 0.9 / std::numbers::pi);
}

// A ramp from 0 to 1 in 2 pi pushes the mass to x = -1 with x' = 0; then it swings between -1
// and 1. Followed to the end it would swing 1e14 times.
BOOST_AUTO_TEST_CASE(what_a_load_can_do_is_known_when_it_is_over) {
  const Record ramp{{0, 1}, 2 * std::numbers::pi, {}};
  for (const std::optional<double> end : {std::optional<double>(), std::optional(9e14)}) {
    BOOST_TEST(load_reach(ramp, 1, end, {}).reach_m == 1, tt::tolerance(tolerance));
  }
}

/// With springs and hits between, whether the notch stops the first arrival or not.
BOOST_AUTO_TEST_CASE(nothing_within_ranges_is_worse_than_at_their_ends) {
  constexpr double rounding = 1 + 1e-12;
  RandomSource random(2606);
  int passes = 0;
  int all_stop = 0;
  for (int i = 0; i < 300; ++i) {
    const double v0 = random.uniform(0.5, 2);
    const double p = random.uniform(0.5, 2);
    const Problem problem{.v0 = v0,
                          .p = p,
                          .beta = 9,
                          .v0_low = v0 * random.uniform(0.7, 1),
                          .p_high = p * random.uniform(1, 2)};
    const double f = *problem.v0_low * p * random.uniform(0, 0.35);
    const double delta = std::pow(*problem.v0_low, 2) * random.uniform(0.1, 0.5);
    const double limit = std::hypot(f, v0 * *problem.p_high) * random.uniform(1, 1.2);
    const Practice worst = worst_practice(problem, {.acceleration_max = limit}, f, delta).value();
    const bool stops = admissible(problem, {}, f, delta);  // every one at its first arrival
    all_stop += stops;
    for (int k = 0; k < 50; ++k) {
      const Oscillator oscillator{p + (*problem.p_high - p) * random.uniform(0, 1), f, delta};
      const double hit = random.uniform(*problem.v0_low, v0);
      const Practice now = of(oscillator, hit, limit).value();
      BOOST_TEST(now.notch_width_min.value() <= worst.notch_width_min.value() * rounding);
      BOOST_TEST(now.base_shear <= worst.base_shear * rounding);
      BOOST_TEST(*now.energy_ratio * rounding >= *worst.energy_ratio);
      BOOST_TEST(*now.equivalent_damping * rounding >= *worst.equivalent_damping);
      if (stops) {
        BOOST_TEST(*now.impulse_at_stop <= *worst.impulse_at_stop * rounding);
        BOOST_TEST(*now.notch_used <= *worst.notch_used * rounding);
      }
    }
    // A rest in the dead zone has no stop.
    passes += worst.impulse_largest > worst.impulse_at_stop;
  }
  BOOST_TEST(passes > 20);
  BOOST_TEST(all_stop > 20);
}

/// A hit that starts is never damped beyond critical, 3/pi at most; a pulse may be.
BOOST_AUTO_TEST_CASE(beyond_critical_there_is_no_equivalent_damping) {
  constexpr double f = 0.5;
  check_close(of({1, f, 0.5}, 1)->equivalent_damping,
              (2 * f + 0.5 / (std::sqrt(1.25) - f)) / (std::numbers::pi * std::sqrt(1.25)));
  constexpr double most = 3 / std::numbers::pi;
  const double with_much_friction = of({1, 1e6, 0.5}, 1)->equivalent_damping.value();
  BOOST_TEST(with_much_friction < most);
  BOOST_TEST(with_much_friction > (1 - 1e-5) * most);
  // xi = Delta/(pi A^2) without constant friction: 1 at Delta = pi A^2.
  Response motion;
  motion.peak_amplitude = 0.5;
  const double critical = std::numbers::pi / 4;
  const auto damping = [&](double delta) {
    return practice({1, 0, delta}, motion, {}, 1.0)->equivalent_damping;
  };
  check_close(damping(0.999 * critical), 0.999);
  BOOST_TEST(!damping(1.001 * critical));
}

/// Of each half-cycle of the motion: the largest change of speed at x = 0.
BOOST_AUTO_TEST_CASE(the_impulses_are_those_of_all_passages_and_the_stop) {
  RandomSource random(2602);
  int stops_largest = 0;
  int passages_largest = 0;
  for (int i = 0; i < 500; ++i) {
    const double v0 = random.log_uniform(1e-2, 1e2);
    const double p = random.log_uniform(1e-2, 1e2);
    const Oscillator oscillator{p, random.log_uniform(1e-3, 0.3) * v0 * p,
                                random.log_uniform(1e-3, 0.4) * v0 * v0};
    std::vector<double> arrivals;
    for (const HalfCycle& now : first_half_cycles(oscillator, {0, v0}, 2000)) {
      if (now.impulse) {
        arrivals.push_back(*now.impulse);
      }
    }
    const auto lines = of(oscillator, v0);
    const auto impulses = design::impulses(oscillator, free_response(oscillator, {0, v0}));
    BOOST_TEST_REQUIRE(impulses.size() == arrivals.size());
    for (std::size_t k = 0; k < impulses.size(); ++k) {
      BOOST_TEST(std::abs(impulses[k] - arrivals[k]) <= 1e-11 * v0);
    }
    const double shown = lines->impulse_largest.value_or(0);
    BOOST_TEST(shown == (impulses.empty() ? 0 : std::ranges::max(impulses)));
    if (lines->impulse_at_stop) {
      (*lines->impulse_at_stop < shown ? passages_largest : stops_largest) += 1;
    }
  }
  BOOST_TEST(stops_largest > 50);
  BOOST_TEST(passages_largest > 50);
}

BOOST_AUTO_TEST_CASE(what_does_not_exist_is_empty) {
  BOOST_TEST(!of({1, 0.1, 1}, 0.5));  // caught at the start
  const Practice undamped = of({2, 0, 0}, 1).value();
  check_close(undamped.secant_stiffness, 4);
  BOOST_TEST(*undamped.equivalent_damping == 0);
  BOOST_TEST(!undamped.energy_ratio);
  BOOST_TEST(!undamped.residual_ratio);
  BOOST_TEST(!undamped.impulse_at_stop);
  BOOST_TEST(!undamped.notch_used);
  BOOST_TEST(!undamped.notch_width_min);
  const Practice off_centre = of({1, 1, 0.1}, 1, 0.9).value();
  BOOST_TEST(!off_centre.impulse_largest);
  BOOST_TEST(!off_centre.notch_width_min);  // f alone is above it
  const Practice notch_alone = of({1, 0, 0.5}, 1).value();
  BOOST_TEST(!notch_alone.energy_ratio);
  BOOST_TEST(*notch_alone.impulse_at_stop == 1);
}

/// Free motions through a notch as wide as the report says, by the kernel with its edges: of
/// dampers that stop at their first arrival, at a later one, or off centre.
BOOST_AUTO_TEST_CASE(a_notch_of_the_least_width_transmits_the_limit) {
  RandomSource random(2605);
  int rests_before = 0;
  int rests_beyond = 0;
  int passes = 0;
  int stopped_earlier = 0;
  for (int i = 0; i < 4000; ++i) {
    const double v0 = random.uniform(0.5, 2);
    const double delta = random.pick(2) == 0 ? random.uniform(0.02, 0.5) : random.uniform(0.2, 0.3);
    const Oscillator oscillator{random.uniform(0.5, 2), v0 * random.uniform(0, 0.3),
                                v0 * v0 * delta};
    const Response response = free_response(oscillator, {0, v0});
    const double limit =
        std::hypot(oscillator.f, oscillator.p * v0) *
        (random.pick(2) == 0 ? random.uniform(1, 2) : 1 + random.log_uniform(1e-6, 0.1));
    const auto lines = practice(oscillator, response, limit);
    const auto with = [&](double width) {
      return forced_response(oscillator, {0, v0}, NoExcitation(), {}, Surface{width, {}});
    };
    const auto felt = [&](double width) { return with(width).peak_absolute_acceleration; };
    if (!lines->impulse_largest) {
      continue;  // rests before the first arrival
    }
    const double width = lines->notch_width_min.value();
    const double least = least_notch_width(oscillator.f, oscillator.delta, limit, 0).value();
    BOOST_TEST(notch_acceleration(oscillator.f, oscillator.delta, least, 0) <= limit);
    BOOST_TEST(std::abs(felt(width) - limit) <= 1e-12 * limit, "felt " << felt(width));
    BOOST_TEST(felt(0.999 * width) > limit);
    for (const double wider : {1.001, 1.03, 1.3, 2.0, 4.0}) {
      BOOST_TEST(felt(wider * width) <= limit, wider << " times " << width);
    }
    const bool one_arrival = response.stops_at_zero && *response.zero_passages == 0;
    if (one_arrival) {
      (*lines->notch_used < 0.5 ? rests_before : rests_beyond) += 1;
    } else {
      (*with(width * (1 - 1e-9)).zero_passages > 1 ? passes : stopped_earlier) += 1;
    }
  }
  BOOST_TEST(rests_before > 100);
  BOOST_TEST(rests_beyond > 100);
  BOOST_TEST(passes > 100);  // the whole notch
  BOOST_TEST(stopped_earlier > 100);
}

/// A load of 0.5 is 0.3 more than f: wider than 0.09/0.3 = 0.3, where 0.2 + 0.3 + p^2
/// 0.15 are felt.
BOOST_AUTO_TEST_CASE(a_load_from_rest_needs_a_notch_that_lets_the_mass_go) {
  const auto least = [](double limit, double p, double load = 0.5) {
    return least_notch_width_from_rest(0.2, 0.09, limit, p, load);
  };
  const double width = least(1, 1).value();
  BOOST_TEST(width == 0.3, tt::tolerance(1e-14));
  BOOST_TEST(0.2 + 0.09 / width < 0.5);
  // With p = 2 that is 1.1, and every wider one is felt more.
  BOOST_TEST(!least(1.09, 2));
  BOOST_TEST(least(1.11, 2).value() == 0.3, tt::tolerance(1e-14));
  BOOST_TEST(!least(1, 1, 0.2));  // friction alone holds it
  // With 0.2 + 0.09/w <= 0.4 the limit needs more.
  BOOST_TEST(least(0.4, 0).value() == 0.45, tt::tolerance(1e-14));
}

/// Of every hit up to the strongest, those below sqrt(2 delta) leave a wide notch against its
/// friction, and feel f + delta/w + p^2 w/2 at its edge.
BOOST_AUTO_TEST_CASE(the_width_of_ranges_is_enough_for_hits_that_the_notch_catches) {
  const double f = 0.2;
  const double delta = 0.45;
  Problem problem{.v0 = 1, .p = 1, .beta = 1};
  const double limit = 1.2;
  const auto width = [&] {
    return worst_practice(problem, {.acceleration_max = limit}, f, delta)->notch_width_min.value();
  };
  const double of_one = width();
  problem.v0_low = 0;
  const double of_all = width();
  BOOST_TEST(of_all == least_notch_width(f, delta, limit, 1).value());
  const auto felt = [&](double wide) {
    double most = 0;
    for (double v0 = 0.01; v0 * v0 < 2 * delta; v0 += 0.01) {
      const auto motion = forced_response({1, f, 0}, {0, v0}, NoExcitation(), {},
                                          Surface{{}, {{wide / 2, f + delta / wide}}});
      most = std::max(most, motion.peak_absolute_acceleration);
    }
    return most;
  };
  BOOST_TEST(felt(of_all) <= limit * (1 + 1e-12));
  BOOST_TEST(felt(of_one) > limit);
}

BOOST_AUTO_TEST_SUITE_END()
