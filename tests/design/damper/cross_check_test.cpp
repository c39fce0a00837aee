// SPDX-License-Identifier: MIT
#include "check/runge_kutta.hpp"
#include "damper.hpp"

BOOST_AUTO_TEST_SUITE(cross_check_test)

using namespace stillpoint::design_test;

constexpr double map_tolerance = 1e-12;
constexpr double runge_kutta_tolerance = 1e-9;

/// A design far from every edge: V0 = p = 1, f = 0.2, Delta = 0.3.
const Problem problem{1, 1, 0.9};
constexpr double f = 0.2;
constexpr double delta = 0.3;

/// The check of the good design with a changed prediction.
CrossCheck check_changed(const std::function<void(Prediction&)>& change) {
  Prediction prediction = predict(problem, f);
  change(prediction);
  return cross_check(prediction, problem, f, delta);
}

/// Both methods notice the change.
void check_fires(const std::function<void(Prediction&)>& change) {
  const CrossCheck check = check_changed(change);
  BOOST_TEST(!check.passed);
  for (const CheckMethod& method : check.methods) {
    BOOST_TEST(!method.passed, method.name << " passes with an error of " << method.relative_error);
  }
}

BOOST_AUTO_TEST_CASE(a_correct_prediction_passes_both_ways) {
  const CrossCheck check = check_changed([](Prediction&) {});
  BOOST_TEST(check.passed);
  BOOST_REQUIRE(check.methods.size() == 2U);
  BOOST_TEST(check.methods[0].name == "half_cycle_map");
  BOOST_TEST(check.methods[1].name == "runge_kutta");
  BOOST_TEST(check.methods[0].tolerance == map_tolerance);
  BOOST_TEST(check.methods[1].tolerance == runge_kutta_tolerance);
  for (const CheckMethod& method : check.methods) {
    BOOST_TEST(method.passed);
    BOOST_TEST(method.decided);
    BOOST_TEST(method.half_cycles == 1);
    BOOST_TEST(method.stop_position == 0);
    BOOST_TEST(method.relative_error <= method.tolerance);
    BOOST_TEST(method.wall_time_s >= 0);
  }
  // Independent methods do not agree to the last bit.
  BOOST_TEST(check.methods[1].relative_error > 0);
}

BOOST_AUTO_TEST_CASE(every_wrong_prediction_is_noticed) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  struct Row {
    const char* name;
    double Prediction::*field;
    double part;
  };
  for (const Row& row : {Row{"peak", &Prediction::peak_amplitude, 1e-6},
                         {"stop time", &Prediction::stop_time, 1e-6},
                         {"acceleration", &Prediction::peak_acceleration, 1e-6},
                         {"arrival speed", &Prediction::arrival_speed, 1e-5}}) {
    for (const double factor : {1 + row.part, 1 - row.part, nan}) {
      BOOST_TEST_CONTEXT(row.name << " times " << factor) {
        check_fires([&](Prediction& wrong) { wrong.*row.field *= factor; });
      }
    }
  }
  for (const double position : {1e-6, -1e-6, nan}) {
    check_fires([&](Prediction& wrong) { wrong.stop_position = position; });
  }
  check_fires([](Prediction& wrong) { wrong.half_cycles = 2; });
  // The reported error of a position is relative to the peak.
  const CrossCheck check =
      check_changed([](Prediction& wrong) { wrong.stop_position = wrong.peak_amplitude / 4; });
  for (const CheckMethod& method : check.methods) {
    BOOST_TEST(method.relative_error == 0.25);
  }
}

BOOST_AUTO_TEST_CASE(each_method_keeps_its_own_tolerance) {
  const CrossCheck check = check_changed([](Prediction& wrong) { wrong.stop_time *= 1 + 1e-10; });
  BOOST_TEST(!check.methods[0].passed);
  BOOST_TEST(check.methods[1].passed);
  BOOST_TEST(!check.passed);
}

BOOST_AUTO_TEST_CASE(a_design_that_does_not_stop_or_start_or_is_another_ones_fails) {
  const double enough = delta1_exact(problem, f).value();
  BOOST_TEST(cross_check(predict(problem, f), problem, f, enough * (1 + 1e-6)).passed);
  for (const double too_little : {enough * (1 - 1e-6), enough * 0.9, enough * 0.1}) {
    const CrossCheck check = cross_check(predict(problem, f), problem, f, too_little);
    for (const CheckMethod& method : check.methods) {
      BOOST_TEST(!method.passed);
      BOOST_TEST(method.half_cycles >= 2);
    }
  }
  for (const CheckMethod& method : cross_check(predict(problem, f), problem, f, 0.51).methods) {
    BOOST_TEST((!method.passed && method.half_cycles == 0));  // it does not start
  }
  for (const CheckMethod& method :
       cross_check(predict({1.001, 1, 0.9}, f), problem, f, delta).methods) {
    BOOST_TEST(!method.passed);  // of another problem
  }
}

/// Without a notch the mass rests off centre, however much friction there is: at the first peak,
/// V0^2 / (p (r + phi)), from phi = V0/sqrt(3) on.
BOOST_AUTO_TEST_CASE(constant_friction_alone_passes) {
  RandomSource random(902);
  for (int i = 0; i < 500; ++i) {
    Problem task{random.log_uniform(0.01, 100), random.log_uniform(0.01, 100), 1};
    task.arrivals = most_arrivals;
    task.beta = task.residual.emplace(1e12 * task.v0 / task.p);
    const double friction = task.v0 * task.p * random.log_uniform(0.01, 1e8);
    const double phi = friction / task.p;
    const Prediction prediction = predict(task, friction, 0);
    if (phi > task.v0 / std::numbers::sqrt3) {
      const double peak = task.v0 / (std::hypot(task.v0, phi) + phi) * task.v0 / task.p;
      BOOST_TEST(std::abs(prediction.stop_position / peak - 1) < 1e-15);
    }
    const CrossCheck check = cross_check(prediction, task, friction, 0);
    for (const CheckMethod& method : check.methods) {
      BOOST_TEST(method.passed, method.name << " is off by " << method.relative_error
                                            << " with f = " << friction << ", v0 = " << task.v0
                                            << ", p = " << task.p);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_grazing_design_passes_and_a_wrong_prediction_of_it_does_not) {
  for (const double distance : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
    const double grazing = admissible_region(problem).f3 * (1 - distance);
    const Prediction prediction = predict(problem, grazing);
    BOOST_TEST_CONTEXT("a relative " << distance << " below f3") {
      BOOST_TEST(cross_check(prediction, problem, grazing, 0.1).passed);
      Prediction wrong = prediction;
      wrong.peak_amplitude *= 1 + 1e-4;
      BOOST_TEST(!cross_check(wrong, problem, grazing, 0.1).passed);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_start_of_the_integrator_tips_at_delta2) {
  // v0 * v0 / 2 is above Delta2 for the first three.
  for (const double v0 : {0.355, 0.759, 1.438, 0.3, 1.0}) {
    const double delta2 = *admissible_region({.v0 = v0, .p = 1, .beta = 9}).delta2;
    const auto motion = stillpoint::design::integrate_free_motion({1, 0.1, delta2}, v0, 1e-12);
    BOOST_TEST(motion.half_cycles == 1);
    BOOST_TEST(motion.peak_amplitude > 0);
    const double more = std::nextafter(delta2, HUGE_VAL);
    BOOST_TEST(stillpoint::design::integrate_free_motion({1, 0.1, more}, v0, 1e-12).half_cycles ==
               0);
  }
}

BOOST_AUTO_TEST_CASE(a_motion_longer_than_allowed_is_not_said_to_stop) {
  const IntegratedMotion motion = integrate_free_motion({1, 0, 0.01}, 1, map_tolerance, 10);
  BOOST_TEST(!motion.stopped);
  BOOST_TEST(motion.half_cycles == 10);
}

BOOST_AUTO_TEST_CASE(wrong_input_of_the_integrator_is_refused) {
  const auto refused = [](const std::string& field, const Oscillator& oscillator, double v0,
                          double tolerance = 1e-12) {
    test::check_refused(field, [&] { return integrate_free_motion(oscillator, v0, tolerance); });
  };
  for (const double wrong : {0.0, -1.0, 1e-151, std::nan(""), double(HUGE_VAL)}) {
    refused("v0", {1, 0.1, 0.1}, wrong);
    refused("p", {wrong, 0.1, 0.1}, 1);
  }
  for (const double wrong : {-1.0, std::nan(""), double(HUGE_VAL)}) {
    refused("f", {1, wrong, 0.1}, 1);
    refused("delta", {1, 0.1, wrong}, 1);
  }
  for (const double wrong : {0.0, 1e-17, 0.1, std::nan("")}) {
    refused("tolerance", {1, 0.1, 0.1}, 1, wrong);
  }
  refused("f, delta", {1, 0, 0}, 1);
}

BOOST_AUTO_TEST_SUITE_END()
