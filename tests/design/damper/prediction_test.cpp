// SPDX-License-Identifier: MIT
#include "damper.hpp"
#include "unit_problem.hpp"
#include "way/unit_strip.hpp"

BOOST_AUTO_TEST_SUITE(prediction_test)

using namespace stillpoint::design_test;

/// Relative, of peak and acceleration: a few roundings.
constexpr double rounding = 1.5e-15;
/// Relative, of stop time and arrival speed, times 1 + f/(p v_-): how much more they turn with f
/// where the arrival slows down.
constexpr double turning = 1.5e-15;
/// Where the arrival grazes, half of the digits are gone and no more.
constexpr double grazing = 5e-8;

/// Up to f3 itself, where it arrives without speed, some very near to it.
double random_f(RandomSource& random, double f3) {
  return random.pick(9) == 0   ? f3
         : random.pick(2) == 0 ? f3 * random.uniform(0, 1)
                               : f3 * (1 - random.log_uniform(1e-14, 0.1));
}

double steepness(const Problem& problem, double f, const Precise& arrival) {
  const double phi = f / problem.p;
  return 1 + phi / std::max(static_cast<double>(arrival), grazing * phi);
}

BOOST_AUTO_TEST_CASE(predictions_are_the_closed_forms_in_50_digits) {
  RandomSource random(801);
  for (int i = 0; i < 5000; ++i) {
    const Problem problem = random_feasible_problem(random);
    const double f = random_f(random, admissible_region(problem).f3);
    const Reference reference(problem);
    const Prediction prediction = predict(problem, f);
    const Precise arrival = reference.arrival_speed(f);
    const double steep = steepness(problem, f, arrival);
    BOOST_TEST(close(prediction.peak_amplitude, reference.peak(f), rounding));
    BOOST_TEST(close(prediction.peak_acceleration, reference.s(f), rounding));
    BOOST_TEST(
        close(prediction.stop_time, reference.stop_time(f), std::min(turning * steep, grazing)));
    BOOST_TEST(within(prediction.arrival_speed, arrival, Precise(turning) * steep * problem.v0));
    BOOST_TEST(prediction.half_cycles == 1);
    BOOST_TEST(prediction.stop_position == 0);
  }
}

BOOST_AUTO_TEST_CASE(without_constant_friction_half_a_period_passes) {
  const Prediction prediction = predict({2, 4, 1}, 0);
  BOOST_TEST(close(prediction.stop_time, std::numbers::pi / 4, rounding));
  BOOST_TEST(prediction.peak_amplitude == 0.5);
  BOOST_TEST(prediction.arrival_speed == 2);
}

BOOST_AUTO_TEST_CASE(no_prediction_beyond_f3_or_below_zero) {
  const Problem problem{1, 1, 0.9};
  for (const double f : {-1e-300, std::nextafter(admissible_region(problem).f3, 1.0), std::nan(""),
                         double(HUGE_VAL)}) {
    test::check_refused("f", [&] { return predict(problem, f); });
  }
}

BOOST_AUTO_TEST_CASE(the_slope_of_the_stop_phase_is_cut_at_f3) {
  BOOST_TEST(std::isfinite(unit::stop_phase_slope(unit::a3)));
  BOOST_TEST(unit::stop_phase_slope(unit::a3) > 1e7);
}

// Of the phase atan2(a, w) of a slow arrival: a/(2 t^2 w) d(w^2), of which the bound is twice that.
BOOST_AUTO_TEST_CASE(the_error_of_a_grazing_arrival_is_its_derivative) {
  const double a3 = 1 / std::sqrt(8.0);
  for (const double distance : {1e-8, 1e-6, 1e-4, 1e-2}) {
    const double a = a3 * (1 - distance);
    const unit::Rest now = unit::rest(a, 1, 1);
    const unit::Rest near = unit::rest(a * (1 - distance * 1e-4), 1, 1);
    BOOST_TEST_REQUIRE(now.half_cycles == 1);
    const double change = std::abs((near.arrival_speed - now.arrival_speed) *
                                   (near.arrival_speed + now.arrival_speed));
    const double turn = std::abs(near.phase - now.phase);
    BOOST_TEST(turn <= now.grazing * change);
    BOOST_TEST(turn >= now.grazing * change / 4);
  }
}

BOOST_AUTO_TEST_SUITE_END()
