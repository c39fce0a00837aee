// SPDX-License-Identifier: MIT
#include "forced_arguments.hpp"
#include "report_fields.hpp"
#include "run_program.hpp"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_SUITE(forced_command_test)

// simulate with an excitation, from the flags to the files.

namespace {

using namespace stillpoint::cli_test;
using nlohmann::json;

}  // namespace

// ---- reports

BOOST_FIXTURE_TEST_SUITE(forced_report, Sandbox)

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
  // Caught at the start; physical: H = 0.1 m, so 20 tau are 20 sqrt(0.1 / 1) = 6.325 s.
  const Arguments caught(
      "simulate --f 0.02 --delta 0.1 --excitation harmonic --k 0.3 --lambda 1 --t-end 20");
  const ProgramRun plain = run(joined(caught, "--v0 0.1 --p 1 --json"));
  BOOST_TEST(plain.err ==
             "stillpoint: locked at x = 0 from tau = 0 of 20; the structure then feels up to 0.3 "
             "g\n");
  const json response = plain.json()["response"];
  BOOST_TEST(response["outcome"] == "caught_at_start");
  BOOST_TEST(response["locked_from"] == 0);
  BOOST_TEST(response["largest_load_while_locked"] == 0.3);
  BOOST_TEST(response["peak_absolute_acceleration"] == 0.3);
  BOOST_TEST(response["peak_acceleration"] == 0);
  const ProgramRun physical =
      run(joined(caught, "--velocity 0.1 --period 6.283185307179586 --gravity 1"));
  BOOST_TEST(physical.err ==
             "stillpoint: locked at x = 0 from 0 s of 6.325 s; the structure then feels up to 0.3 "
             "g\n");
  BOOST_TEST(contains(physical.out, "Locked at x = 0 from 0 s of"));
  // A load that is over, or a start that is fast enough, does not lock.
  BOOST_TEST(run(joined(pulse("half-sine"), "--json")).err.empty());
}

BOOST_AUTO_TEST_CASE(of_a_motion_that_stops_says_where_and_when) {
  const json response = reported(pulse("half-sine"))["response"];
  check_response_fields(response);
  BOOST_TEST(response["outcome"] == "stopped_in_dead_zone");
  BOOST_TEST(response["end_time"] == response["stop_time"]);
  BOOST_TEST(response["final_position"] == response["stop_position"]);
  BOOST_TEST(response["final_velocity"] == 0);
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
  BOOST_TEST(response["peak_amplitude"] == 0);
  BOOST_TEST(response["half_cycles"] == 0);
  BOOST_TEST(response["stop_time"] == 0);
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
  const ProgramRun sticking = succeed(joined(s4, "--verbose"));
  check_contains(sticking.out,
                 {"Forced motion", "harmonic, k = 0.2, lambda = 0.35", "is still moving at the end",
                  "22 sticks, tau = 102.9", "tau = 200, x = 0.078877"});
  // x and v by a Runge-Kutta method of step 1e-4: 92.08 mm, 0.3672 m/s
  const ProgramRun metric = succeed(
      "simulate --period 2.8s --f 0.05 --delta-m 0 --excitation harmonic --k 0.1 "
      "--excitation-frequency 0.5Hz --end-time 60s --verbose");
  check_contains(metric.out, {"lambda = 1.4 = 0.5 Hz", "v = 0.08404", " = 0.3673 m/s"});
  // The last half-cycle is still under way: it does not rest.
  const ProgramRun running = run(harmonic);
  BOOST_TEST(contains(running.out, "goes on\n"), running.out);
  const ProgramRun resting = run(pulse("half-sine"));
  BOOST_TEST(contains(resting.out, "rests\n"), resting.out);
}

BOOST_AUTO_TEST_SUITE_END()

// ---- figures that other programs found

BOOST_FIXTURE_TEST_SUITE(forced_reference, Sandbox)

BOOST_AUTO_TEST_CASE(scene_with_stops) {
  const json response = reported(s4)["response"];
  BOOST_TEST(near(response["peak_amplitude"], 0.33344255898459425, 1e-13));
  BOOST_TEST(near(response["final_position"], 0.078877420102046286, 1e-12));
  BOOST_TEST(response["zero_passages"] == 22);
  BOOST_TEST(response["sticks"] == 22);
  BOOST_TEST(response["stick_time"].get<double>() > 0);
}

BOOST_AUTO_TEST_CASE(scene_of_a_record) {
  write("s5.txt", column_file(record_s5()));
  const json report = reported(joined(s5, "--v0 0 --record-step 0.02 --t-end 59.98"));
  const json& response = report["response"];
  BOOST_TEST(near(response["peak_amplitude"], 0.098335012538125103, 1e-12));
  BOOST_TEST(near(response["final_position"], -0.0015776946596039220, 1e-9));
  BOOST_TEST(response["zero_passages"] == 18);
  BOOST_TEST(response["end_time"] == 59.98);
  check_fields(report["input"]["excitation"],
               {"k:null", "lambda:null", "phase:null", "duration:number", "record:text"});
  BOOST_TEST(report["input"]["excitation"]["type"] == "record");
  BOOST_TEST(report["input"]["excitation"]["record"] == "s5.txt");
  BOOST_TEST(report["input"]["excitation"]["samples"] == 3000);
}

BOOST_AUTO_TEST_SUITE_END()

BOOST_AUTO_TEST_SUITE_END()
