// SPDX-License-Identifier: MIT
#include "check/runge_kutta.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(runge_kutta_test)

using namespace stillpoint::design_test;

constexpr double tight = 1e-12;  ///< the integrator's
/// Of times, p T, for each half-cycle, and of lengths, relative to V0/p, at that tolerance.
constexpr double time_tolerance = 5e-10;
constexpr double length_tolerance = 2e-10;
/// Of v^2/V0^2 after a half-cycle; near a tie it is divided by the margin.
constexpr double energy_error = 1e-11;
/// Below this decision margin the errors of the integrator may change a count.
constexpr double clear_margin = 1e-7;

IntegratedMotion integrate(double v0, double p, double f, double delta) {
  return integrate_free_motion({p, f, delta}, v0, tight);
}

void check_refused(const std::string& field, const Oscillator& oscillator, double v0,
                   double tolerance) {
  test::check_refused(field, [&] { return integrate_free_motion(oscillator, v0, tolerance); });
}

BOOST_AUTO_TEST_CASE(motions_of_many_half_cycles_are_those_of_the_map) {
  RandomSource random(1001);
  int clear = 0;
  int longest = 0;
  for (int i = 0; i < 1500; ++i) {
    const double v0 = random.log_uniform(1e-4, 1e4);
    const double p = random.log_uniform(1e-4, 1e4);
    // Of one friction alone the map is a closed form.
    const double f = i % 10 == 0 ? 0 : random.log_uniform(1e-2, 0.5) * v0 * p;
    const double delta = i % 10 == 1 ? 0 : random.log_uniform(1e-3, 0.5) * v0 * v0;
    const Response expected = free_response({p, f, delta}, {0, v0});
    if (*expected.decision_margin < clear_margin) {
      continue;
    }
    ++clear;
    longest = std::max(longest, static_cast<int>(*expected.half_cycles));
    const IntegratedMotion motion = integrate(v0, p, f, delta);
    BOOST_TEST_CONTEXT("v0 = " << v0 << ", p = " << p << ", f = " << f << ", delta = " << delta
                               << ", margin = " << *expected.decision_margin) {
      BOOST_TEST(motion.stopped);
      BOOST_TEST(motion.half_cycles == *expected.half_cycles);
      BOOST_TEST(std::abs(motion.peak_amplitude / expected.peak_amplitude - 1) <= length_tolerance);
      BOOST_TEST(std::abs(motion.stop_time - *expected.stop_time) * p <=
                 *expected.half_cycles *
                     (time_tolerance + energy_error / *expected.decision_margin));
      BOOST_TEST((motion.stop_position == 0) == expected.stops_at_zero);
      BOOST_TEST(std::abs(motion.stop_position - *expected.stop_position) <=
                 length_tolerance * *expected.half_cycles * expected.peak_amplitude);
    }
  }
  BOOST_TEST_MESSAGE(clear << " motions, the longest with " << longest << " half-cycles");
  BOOST_TEST(clear > 1400);
  BOOST_TEST(longest > 20);
}

BOOST_AUTO_TEST_CASE(the_error_falls_with_the_tolerance) {
  const Oscillator oscillator{1, 0.02, 0.03};
  const Response exact = free_response(oscillator, {0, 1});
  BOOST_TEST(*exact.half_cycles > 5);
  std::vector<double> errors;
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const IntegratedMotion motion = integrate_free_motion(oscillator, 1, tolerance);
    BOOST_TEST(motion.half_cycles == *exact.half_cycles);
    errors.push_back(std::abs(motion.stop_time - *exact.stop_time));
    BOOST_TEST_MESSAGE("tolerance " << tolerance << ", error " << errors.back());
    BOOST_TEST(errors.back() <= 1000 * tolerance);
  }
  // Two decades of tolerance are at least one of error; half-way that of a fifth-order method.
  for (std::size_t i = 1; i < errors.size(); ++i) {
    BOOST_TEST(errors[i] < errors[i - 1] / 10);
  }
  BOOST_TEST(errors.back() > 0);
}

BOOST_AUTO_TEST_CASE(an_arrival_that_grazes_x_0_is_counted_right) {
  const double f3 = 1 / std::sqrt(8.0);
  for (const double distance : {1e-9, 1e-7, 1e-5, 1e-3}) {
    BOOST_TEST_CONTEXT("a relative " << distance << " from f3") {
      const IntegratedMotion returns = integrate(1, 1, f3 * (1 - distance), 0.3);
      BOOST_TEST(returns.stopped);
      BOOST_TEST(returns.half_cycles == 1);
      BOOST_TEST(returns.stop_position == 0);
      // Rests a little before x = 0, at 2f - B = 3f - S.
      const double f = f3 * (1 + distance);
      const IntegratedMotion stays = integrate(1, 1, f, 0.3);
      BOOST_TEST(stays.stopped);
      BOOST_TEST(stays.half_cycles == 1);
      BOOST_TEST(std::abs(stays.stop_position - (3 * f - std::sqrt(1 + f * f))) <=
                 length_tolerance);
      BOOST_TEST(stays.stop_position > 0);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_motion_caught_at_the_start_takes_no_time) {
  const IntegratedMotion motion = integrate(1, 1, 0.1, 0.6);
  BOOST_TEST(motion.stopped);
  BOOST_TEST(motion.half_cycles == 0);
  BOOST_TEST(motion.stop_time == 0);
  BOOST_TEST(motion.peak_amplitude == 0);
  // At Delta = V0^2/2 itself it starts.
  BOOST_TEST(integrate(1, 1, 0.1, 0.5).half_cycles == 1);
}

BOOST_AUTO_TEST_CASE(a_motion_longer_than_allowed_is_not_said_to_stop) {
  const IntegratedMotion motion = integrate_free_motion({1, 0, 0.01}, 1, tight, 10);
  BOOST_TEST(!motion.stopped);
  BOOST_TEST(motion.half_cycles == 10);
}

BOOST_AUTO_TEST_CASE(wrong_input_of_the_integrator_is_refused) {
  for (const double wrong : {0.0, -1.0, 1e-151, std::nan(""), double(HUGE_VAL)}) {
    check_refused("v0", {1, 0.1, 0.1}, wrong, tight);
    check_refused("p", {wrong, 0.1, 0.1}, 1, tight);
  }
  for (const double wrong : {-1.0, std::nan(""), double(HUGE_VAL)}) {
    check_refused("f", {1, wrong, 0.1}, 1, tight);
    check_refused("delta", {1, 0.1, wrong}, 1, tight);
  }
  for (const double wrong : {0.0, 1e-17, 0.1, std::nan("")}) {
    check_refused("tolerance", {1, 0.1, 0.1}, 1, wrong);
  }
  check_refused("f, delta", {1, 0, 0}, 1, tight);
}

BOOST_AUTO_TEST_SUITE_END()
