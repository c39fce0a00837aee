// SPDX-License-Identifier: MIT
#include "motion.hpp"

BOOST_AUTO_TEST_SUITE(simulation_test)

using namespace stillpoint;

SimulationRequest forced() {
  return test::simulation_of({1, 0.1, 0.01}, {}, Harmonic{0.5, 0.7, 0, 20});
}

BOOST_AUTO_TEST_CASE(a_free_motion_is_traced_to_its_end) {
  SimulationRequest request = test::simulation_of({1, 0.1, 0.1}, {0, 1});
  request.samples = 50;
  const Simulation motion = simulate(request);
  BOOST_TEST(!motion.forced.has_value());
  BOOST_TEST(motion.half_cycles.back().last);
  BOOST_TEST(motion.half_cycles.back().end_time == motion.response.stop_time.value());
  BOOST_TEST(motion.trajectory.back().tau == motion.response.stop_time.value());
  BOOST_TEST(motion.trajectory.size() > 50U);  // the events as well
}

BOOST_AUTO_TEST_CASE(without_friction_ten_periods_are_traced) {
  SimulationRequest request = test::simulation_of({2, 0, 0}, {1, 0});
  request.samples = 2;
  const double ten_periods = 10 * 3.14159265358979323846;  // pi each
  test::near("end", simulate(request).trajectory.back().tau, ten_periods, 1e-15);
}

BOOST_AUTO_TEST_CASE(a_forced_run_ends_at_t_end) {
  SimulationRequest request = forced();
  request.t_end = 7;
  request.samples = 2;
  const Simulation motion = simulate(request);
  BOOST_TEST((motion.horizon == 7));
  BOOST_TEST(motion.trajectory.back().tau == 7);
  BOOST_TEST(motion.half_cycles.back().end_time == 7);
  BOOST_TEST((motion.response.outcome == Outcome::running));
}

BOOST_AUTO_TEST_CASE(a_run_that_is_stopped_says_so) {
  SimulationRequest request = forced();
  request.excitation = Harmonic{0.5, 0.7, 0};
  request.t_end = 1e6;
  const Simulation motion = simulate(request, [](double) { return false; });
  BOOST_TEST(motion.cancelled);
  BOOST_TEST(motion.half_cycles.empty());
}

/// One run gives what each part gives by itself.
BOOST_AUTO_TEST_CASE(a_run_has_the_bits_of_its_parts) {
  test::Dice dice(7);
  for (int i = 0; i < test::forced_scene_count() / 5; ++i) {
    const test::ForcedScene<> scene = test::random_damped_scene(dice);
    SimulationRequest request{.oscillator = scene.oscillator(),
                              .start = scene.motion.start(),
                              .excitation = scene.excitation,
                              .surface = scene.surface,
                              .t_end = {},
                              .half_cycle_limit = {}};
    if (i % 2 == 0 || !duration(scene.excitation)) {
      request.t_end = scene.t_end;
    }
    if (has_closed_form(request)) {
      continue;
    }
    const auto end = is_forced(request) ? request.t_end : std::nullopt;
    const Oscillator oscillator = request.oscillator;
    const Simulation motion = simulate(request);
    const ForcedResponse response =
        forced_response(oscillator, request.start, request.excitation, {end}, request.surface);
    BOOST_TEST_CONTEXT("scene " << i << ": " << scene) {
      if (motion.forced) {
        BOOST_TEST((*motion.forced == response));
      }
      // Without t_end a record ends where its duration is rounded to, not at its last sample.
      if (motion.forced && (end || !std::holds_alternative<Record>(request.excitation))) {
        BOOST_TEST(
            (motion.half_cycles == forced_half_cycles(oscillator, request.start, request.excitation,
                                                      *motion.horizon, request.max_half_cycles, {},
                                                      request.surface)));
      }
      BOOST_TEST((motion.energies == motion_energies(oscillator, request.start, request.excitation,
                                                     {end}, request.surface)));
    }
  }
}

/// p tau is at most 1e15: with so little friction the rest lies far beyond.
BOOST_AUTO_TEST_CASE(a_rest_too_late_to_be_listed_is_refused) {
  SimulationRequest request = forced();
  request.oscillator = {1, 1e-17, 0};
  stillpoint::test::check_refused("t_end", [&] { return simulate(request); });
}

BOOST_AUTO_TEST_SUITE_END()
