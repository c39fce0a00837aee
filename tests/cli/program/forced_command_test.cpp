// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(forced_command_test, stillpoint::cli_test::Sandbox)

// simulate with an excitation, from the flags to the files.

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(of_a_motion_that_locks_says_so_on_standard_error_too) {
  // Caught at the start; physical: H = 0.1 m and g = 0.1 m/s2, so 20 tau are 20 s.
  const Arguments caught(
      "simulate --f 0.02 --delta 0.1 --excitation harmonic --k 0.3 --lambda 1 --t-end 20");
  const ProgramRun plain = run(caught + "--v0 0.1 --p 1 --json");
  BOOST_TEST(plain.err ==
             "stillpoint: locked at x = 0 throughout the load; the structure feels up to 0.3 g\n");
  const json response = plain.json()["response"];
  check_values(response, {{"outcome", "caught_at_start"},
                          {"locked_from", 0},
                          {"largest_load_while_locked", 0.3},
                          {"peak_absolute_acceleration", 0.3},
                          {"peak_acceleration", 0}});
  // Stopped at its first return.
  const Arguments stopped(
      "simulate --f 0.3 --delta 0.4 --excitation harmonic --k 0.05 --lambda 3 --t-end 20");
  BOOST_TEST(
      contains(run(stopped + "--v0 1 --p 1").err, " of 20; the structure then feels up to "));
  const ProgramRun physical =
      run(stopped + "--velocity 0.1 --period 6.283185307179586 --gravity 0.1");
  BOOST_TEST(contains(physical.err, " s of 20 s; the structure then feels up to "), physical.err);
  BOOST_TEST(contains(physical.out, "Locked at x = 0 from "));
  // A load that is over, or a start that is fast enough, does not lock.
  BOOST_TEST(run(pulse("half-sine") + "--json").err.empty());
}

BOOST_AUTO_TEST_CASE(of_a_motion_that_stops_says_where_and_when) {
  const json response = reported(pulse("half-sine"))["response"];
  check_values(response, {{"outcome", "stopped_in_dead_zone"},
                          {"end_time", response["stop_time"]},
                          {"final_position", response["stop_position"]},
                          {"final_velocity", 0}});
}

BOOST_AUTO_TEST_CASE(of_a_motion_that_never_stops_has_null_for_missing_values) {
  const json report = reported(free_at_rest("--excitation rectangle --k 0.5 --lambda 2"));
  check_null(report["response"],
             {"half_cycles", "turning_points", "zero_passages", "stop_time", "stop_position",
              "arrival_speed", "end_time", "final_position", "final_velocity"});
  BOOST_TEST(report["response"]["outcome"] == "never_stops");
  check_null(report["input"], {"t_end"});
  check_null(report["input"]["excitation"], {"phase"});
}

BOOST_AUTO_TEST_CASE(of_a_mass_that_never_moves_is_at_rest_from_the_start) {
  const json report = reported(at_rest("--excitation harmonic --k 0.1 --lambda 1 --t-end 9"));
  const json& response = report["response"];
  check_values(response, {{"peak_amplitude", 0}, {"half_cycles", 0}, {"stop_time", 0}});
  check_null(response, {"arrival_speed"});
  BOOST_TEST(report["half_cycles"].empty());

  const json caught = reported(
      "simulate --v0 1 --p 1 --f 0.1 --delta 0.6 --excitation harmonic --k 9 --lambda 1 --t-end 9")
      ["response"];
  BOOST_TEST(caught["outcome"] == "caught_at_start");
  BOOST_TEST(caught["end_time"] == 0);
}

BOOST_AUTO_TEST_CASE(for_people_names_the_excitation_and_the_end) {
  const ProgramRun sticking = succeed(s4 + "--verbose");
  check_contains(sticking.out,
                 {"Forced motion", "harmonic, k = 0.2, lambda = 0.35", "is still moving at the end",
                  "22 sticks, tau = 102.9", "tau = 200, x = 0.078877"});
  // x and v by a Runge-Kutta method of step 1e-4: 92.08 mm, 0.3672 m/s
  const ProgramRun metric = succeed(
      "simulate --period 2.8s --f 0.05 --delta-m 0 --excitation harmonic --k 0.1 "
      "--excitation-frequency 0.5Hz --end-time 60s --verbose");
  check_contains(metric.out, {"k = 0.1, 0.5 Hz", "v = 0.3673 m/s"});
  // The last half-cycle does not arrive at x = 0: under way, and at rest.
  for (const Arguments& last : {Arguments(harmonic), Arguments(pulse("half-sine"))}) {
    const ProgramRun answer = run(last);
    BOOST_TEST(contains(answer.out, " none\n"), answer.out);
  }
}

BOOST_AUTO_TEST_CASE(scene_of_a_record_has_the_figures_that_other_programs_found) {
  write("s5.txt", column_file(record_s5()));
  const json report = reported(s5 + "--v0 0 --record-step 0.02 --t-end 59.98");
  const json& response = report["response"];
  BOOST_TEST(near(response["peak_amplitude"], 0.098335012538125103, 1e-12));
  BOOST_TEST(near(response["final_position"], -0.0015776946596039220, 1e-9));
  BOOST_TEST(response["zero_passages"] == 18);
  BOOST_TEST(response["end_time"] == 59.98);
  check_null(report["input"]["excitation"], {"k", "lambda", "phase"});
  check_values(report["input"]["excitation"],
               {{"type", "record"}, {"record", "s5.txt"}, {"samples", 3000}});
}

BOOST_AUTO_TEST_SUITE_END()
