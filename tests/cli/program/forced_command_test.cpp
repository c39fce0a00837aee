// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

BOOST_FIXTURE_TEST_SUITE(forced_command_test, stillpoint::cli_test::Sandbox)

// simulate with an excitation, from the flags to the files.

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(has_every_field_of_the_contract) {
  const json report = reported(s3);
  BOOST_TEST(report["schema"] == "stillpoint/simulation-report/1");
  check_fields(report, {"program:object", "input:object", "response:object", "half_cycles:array",
                        "half_cycles_listed:count", "physical:null"});
  check_fields(report["input"], {"v0:number", "p:number", "f:number", "delta:number", "x0:number",
                                 "t_end:number", "excitation:object"});
  check_fields(report["input"]["excitation"],
               {"type:text", "k:number", "lambda:number", "phase:number", "duration:null",
                "record:null", "samples:null"});
  check_fields(
      report["response"],
      {"peak_amplitude:number", "peak_acceleration:number", "peak_absolute_acceleration:number",
       "locked_from:null", "largest_load_while_locked:null", "half_cycles:count",
       "turning_points:count", "zero_passages:count", "stop_time:null", "stop_position:null",
       "stops_at_zero:bool", "outcome:text", "arrival_speed:number", "decision_margin:number",
       "end_time:number", "final_position:number", "final_velocity:number", "sticks:count",
       "stick_time:number"});
  for (const json& now : report["half_cycles"]) {
    check_fields(now,
                 {"index:count", "start_time:number", "departure_speed:number", "peak_time:number",
                  "peak:number", "end_time:number", "arrival_speed:number?"});
  }
}

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
  check_response_fields(response);
  check_values(response, {{"outcome", "stopped_in_dead_zone"},
                          {"end_time", response["stop_time"]},
                          {"final_position", response["stop_position"]},
                          {"final_velocity", 0}});
}

BOOST_AUTO_TEST_CASE(of_a_motion_that_never_stops_has_null_for_missing_values) {
  const json report = reported(free_at_rest("--excitation rectangle --k 0.5 --lambda 2"));
  check_fields(
      report["response"],
      {"peak_amplitude:number", "half_cycles:null", "turning_points:null", "zero_passages:null",
       "stop_time:null", "stop_position:null", "arrival_speed:null", "end_time:null",
       "final_position:null", "final_velocity:null", "sticks:count", "stick_time:number"});
  BOOST_TEST(report["response"]["outcome"] == "never_stops");
  check_fields(report["input"], {"t_end:null"});
  check_fields(report["input"]["excitation"], {"phase:null", "duration:number"});
}

BOOST_AUTO_TEST_CASE(of_a_mass_that_never_moves_is_at_rest_from_the_start) {
  const json report = reported(at_rest("--excitation harmonic --k 0.1 --lambda 1 --t-end 9"));
  const json& response = report["response"];
  check_values(response, {{"peak_amplitude", 0}, {"half_cycles", 0}, {"stop_time", 0}});
  check_fields(response, {"arrival_speed:null"});
  BOOST_TEST(report["half_cycles"].empty());

  const json caught = reported(
      "simulate --v0 1 --p 1 --f 0.1 --delta 0.6 --excitation harmonic --k 9 --lambda 1 --t-end 9")
      ["response"];
  BOOST_TEST(caught["outcome"] == "caught_at_start");
  BOOST_TEST(caught["end_time"] == 0);
}

BOOST_AUTO_TEST_CASE(of_a_free_motion_has_no_excitation) {
  const json report = reported("simulate --v0 1 --p 1 --f 0.02 --delta 0.02");
  check_fields(report["input"], {"excitation:null", "t_end:null"});
  BOOST_TEST(!report["response"].contains("sticks"));
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
  check_contains(metric.out, {"lambda = 1.4 = 0.5 Hz", "v = 0.08404", " = 0.3673 m/s"});
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
  check_fields(report["input"]["excitation"],
               {"k:null", "lambda:null", "phase:null", "duration:number", "record:text"});
  check_values(report["input"]["excitation"],
               {{"type", "record"}, {"record", "s5.txt"}, {"samples", 3000}});
}

BOOST_AUTO_TEST_SUITE_END()
