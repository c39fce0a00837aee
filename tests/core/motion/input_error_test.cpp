// SPDX-License-Identifier: MIT
#include "motion.hpp"

namespace stillpoint::test {

BOOST_AUTO_TEST_SUITE(input_error_test)

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

struct Field {
  const char* name;
  double Scene<>::*input;
  std::vector<double> wrong;
};

const std::array<Field, 5> fields{{
    {"x0", &Scene<>::x0, {nan, inf, -inf, 2e300, -2e300, 1e-151, 1e151}},
    {"v0", &Scene<>::v0, {nan, inf, -inf, 2e150, -2e150, 1e-151, -5e-324}},
    {"p", &Scene<>::p, {nan, inf, -inf, 0, -0.0, -1, 1e-151, 1e151}},
    {"f", &Scene<>::f, {nan, inf, -inf, -1e-9, 2e300, 2e150}},
    {"delta", &Scene<>::delta, {nan, inf, -inf, -1e-9, 2e300}},
}};

BOOST_AUTO_TEST_CASE(every_wrong_input_is_named) {
  for (const Field& field : fields) {
    for (const double value : field.wrong) {
      BOOST_TEST_CONTEXT(field.name << " = " << value) {
        Scene<> scene{0.5, 1, 1, 0.1, 0.1};
        scene.*field.input = value;
        check_refused(field.name, [&] { (void)response(scene); });
        check_refused(field.name, [&] { (void)free_peak(scene.oscillator(), scene.start()); });
        check_refused(field.name,
                      [&] { (void)first_half_cycles(scene.oscillator(), scene.start(), 1); });
        check_refused(field.name,
                      [&] { Trajectory(scene.oscillator(), scene.start(), {.horizon = 1}); });
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(the_bounds_themselves_are_accepted) {
  for (const Scene<>& scene : {Scene<>{0, 1e150, 1e150, 0, 1e300},
                               {0, -1e-150, 1e-150, 0, 1e-300},
                               {0, 1, 1, 0, 5e-324},
                               {0, 1e150, 1, 1e150, 0},
                               {1e300, 0, 1e-150, 1e-10, 0},
                               {1e-300, 0, 1e150, 0, 1e-300},
                               {0, 0.0, 1, 0, 0},
                               {-0.0, -0.0, 1, -0.0, -0.0}}) {
    BOOST_TEST_CONTEXT("scene " << scene) {
      BOOST_CHECK_NO_THROW(require_valid(scene.oscillator(), scene.start()));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_inputs_make_together_is_bounded) {
  for (const auto& [field, scene] : {std::pair{"x0", Scene<>{1e149, 0, 10.1, 0, 0}},
                                     {"x0", {1e-300, 0, 1e149, 0, 0}},
                                     {"x0", {1e-300, 0, 1e-150, 0, 0}},  // p x0 underflows
                                     {"f", {0, 1, 1e-149, 10.1, 0}},
                                     // f / p = 1e-350 is not a double: 5e199 half-cycles, but not a
                                     // motion that never stops.
                                     {"f", {0, 1e-150, 1e150, 1e-200, 0}},
                                     {"f", {0, 1, 1e8, 1e-300, 0.1}},
                                     // The peak underflows: p A = V0^2 p / (2f) = 5e-451.
                                     {"f", {0, 1e-150, 1e-150, 1, 0}},
                                     // Wrong even for a start at rest.
                                     {"delta", {0, 0, 1, 0, nan}},
                                     {"f", {0, 0, 1, -1, 0}}}) {
    check_refused(field, [&, scene = scene] { (void)response(scene); });
  }
  BOOST_CHECK_NO_THROW((void)response({0, 1, 1, 1e-300, 0.1}));
}

BOOST_AUTO_TEST_CASE(a_wrong_half_cycle_limit_is_named) {
  for (const double limit : {0.0, 0.5, -1.0, 1.1e15, nan, inf}) {
    check_refused("half_cycle_limit", [&] {
      (void)response({0, 1, 1, 0.1, 0.1}, {.half_cycle_limit = limit});
    });
  }
}

BOOST_AUTO_TEST_CASE(the_message_says_the_value_and_the_bound) {
  const std::string text = refusal_of<InputError>([] { (void)response({0, 1, -1, 0.1, 0.1}); });
  BOOST_TEST(text == "p = -1: must be a number from 1e-150 to 1e+150");
}

BOOST_AUTO_TEST_CASE(both_frictions_vanishing_are_too_many_half_cycles) {
  const Scene<> scene{0, 1, 1, 1e-300, 1e-300};
  const std::string text = refusal_of<TooManyHalfCycles>([&] { (void)response(scene); });
  BOOST_TEST(text.find("f and delta") != std::string::npos, text);
  BOOST_TEST(text.find("1e+08") != std::string::npos, text);
  BOOST_CHECK_NO_THROW((void)free_peak(scene.oscillator(), scene.start()));
}

BOOST_AUTO_TEST_CASE(wrong_limits_of_a_trajectory_are_named) {
  const Scene<> scene{0, 1, 1, 0.1, 0.1};
  for (const double horizon : {0.0, -1.0, nan, inf}) {
    check_refused("horizon",
                  [&] { Trajectory(scene.oscillator(), scene.start(), {.horizon = horizon}); });
  }
  const Scene<> endless{0, 1, 1, 0, 0};
  const std::string missing = refusal_of<InputError>(
      [&] { Trajectory(endless.oscillator(), endless.start(), TrajectoryOptions{}); });
  BOOST_TEST(missing.starts_with("horizon"), missing);
  const Trajectory path(scene.oscillator(), scene.start(), {.horizon = 2});
  for (const double tau : {-1e-9, 2.1, nan, inf}) {
    check_refused("tau", [&] { (void)path.at(tau); });
  }
  for (const int samples : {1, 0, -5}) {
    check_refused("samples", [&] { (void)path.sampled(samples); });
  }
}

BOOST_AUTO_TEST_CASE(a_trajectory_of_more_half_cycles_than_allowed_is_refused) {
  const Scene<> scene{0, 1, 1, 0, 0};
  const TrajectoryOptions few{.horizon = 100, .half_cycles = 10};
  BOOST_CHECK_THROW(Trajectory(scene.oscillator(), scene.start(), few), TooManyHalfCycles);
  const TrajectoryOptions enough{.horizon = 31, .half_cycles = 10};  // 10 pi = 31.4
  BOOST_CHECK_NO_THROW(Trajectory(scene.oscillator(), scene.start(), enough));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace stillpoint::test
