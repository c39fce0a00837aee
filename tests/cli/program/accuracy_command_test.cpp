// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(accuracy_command_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;

const Arguments s1("accuracy --v0 1 --p 1 --f 0.02 --delta 0.02");
const Arguments s4(
    "accuracy --v0 0.5 --p 1 --f 0.18 --delta 0 --excitation harmonic --k 0.2 --lambda 0.35 "
    "--t-end 200");

/// The first of a name: the kernel's, or the one with a setting.
json method(const json& report, const std::string& name, const std::string& setting = "") {
  for (const json& now : report["methods"]) {
    if (now["name"] == name && (setting.empty() || now["setting"] == setting)) {
      return now;
    }
  }
  BOOST_FAIL("no method " << name << ' ' << setting);
  return {};
}

}  // namespace

// data/reference, made without the kernel.
BOOST_AUTO_TEST_CASE(reference_matches_the_tables) {
  const json free = reported(s1);
  BOOST_TEST(free["schema"] == "stillpoint/accuracy-report/1");
  BOOST_TEST(free["reference"]["peak_amplitude"] == 0.98019998000399900);
  BOOST_TEST(near(free["reference"]["end_time"], 34.598868822426208, 1e-15));
  BOOST_TEST(free["reference"]["turning_points"] == 11);
  BOOST_TEST(free["reference"]["outcome"] == "stopped_at_zero");
  const json forced = reported(s4);
  BOOST_TEST(near(forced["reference"]["peak_amplitude"], 0.33344255898459425, 1e-15));
  BOOST_TEST(near(forced["reference"]["final_position"], 0.078877420102046286, 1e-15));
  BOOST_TEST(forced["reference"]["zero_passages"] == 22);
  BOOST_TEST(forced["reference"]["sticks"] == 22);
}

// H = 0.4^2/9.80665/p^2 with p = 2 pi/2.8 s * 0.4 m/s / g.
BOOST_AUTO_TEST_CASE(physical_input_has_its_answer_in_metres_too) {
  const Arguments scene("accuracy --velocity 0.4 --period 2.8s --f 0.02 --delta-m 6mm");
  const json report = reported(scene);
  const json& physical = report["physical"];
  const double length_m = 0.4 * 2.8 / (2 * std::acos(-1.0));
  BOOST_TEST(near(physical["length_unit_m"], length_m, 1e-15));
  BOOST_TEST(near(physical["peak_m"],
                  report["reference"]["peak_amplitude"].get<double>() * length_m, 1e-15));
  BOOST_TEST(physical["final_velocity_m_per_s"] == 0);
  BOOST_TEST(reported(s1)["physical"].is_null());
}

BOOST_AUTO_TEST_CASE(kernel_is_the_one_that_simulate_uses_and_is_right) {
  for (const Arguments& scene : {s1, s4}) {
    const json report = reported(scene);
    const json kernel = method(report, "stillpoint");
    BOOST_TEST(kernel["used_by_simulate"] == true);
    BOOST_TEST(kernel["counts_right"] == true);
    BOOST_TEST(kernel["peak_error"].get<double>() <= 1e-15);
    BOOST_TEST(kernel["end_error"].get<double>() <= 1e-14);
    BOOST_TEST(kernel["wall_time_s"].get<double>() > 0);
    BOOST_TEST(!report["why"].get<std::string>().empty());
    const auto used = std::ranges::count_if(
        report["methods"], [](const json& now) { return now["used_by_simulate"] == true; });
    BOOST_TEST(used == 1);
  }
}

// 424 half-cycles: what a loose setting gets wrong is reported as wrong.
BOOST_AUTO_TEST_CASE(wrong_count_is_shown_as_wrong) {
  const json report = reported("accuracy --v0 1 --p 1 --f 1e-3 --delta 1e-4");
  BOOST_TEST(method(report, "regularised")["counts_right"] == false);
  BOOST_TEST(method(report, "stillpoint")["counts_right"] == true);
  const ProgramRun page = run("accuracy --v0 1 --p 1 --f 1e-3 --delta 1e-4");
  BOOST_TEST(contains(page.out, "wrong"));
}

BOOST_AUTO_TEST_CASE(pulse_and_record_are_compared_too) {
  write("w.txt", "0.3\n-0.2\n0.1\n");
  const Arguments shaken("accuracy --p 1 --f 0.05 --delta 0.001");
  for (const Arguments& excitation : {Arguments("--excitation half-sine --k 0.5 --lambda 4"),
                                      Arguments("--record w.txt --record-step 0.5")}) {
    const json report = reported(shaken + excitation);
    BOOST_TEST(method(report, "stillpoint")["counts_right"] == true);
    BOOST_TEST(method(report, "dopri5", "tolerance 1e-12")["counts_right"] == true);
    BOOST_TEST(method(report, "dopri5", "tolerance 1e-12")["end_error"].get<double>() < 1e-9);
  }
}

BOOST_AUTO_TEST_CASE(rest_under_a_load_is_final_for_it_as_for_simulate) {
  const Arguments held(
      "--v0 0 --p 1 --f 1 --delta 0 --x0 -0.5 --excitation half-sine --k 0.5 --lambda 1");
  const Arguments stops(
      "--v0 1 --p 1 --f 0.8 --delta 0 --excitation rectangle --k 0.5 --lambda 0.1");
  for (const Arguments& scene : {held, stops}) {
    const json report = reported("accuracy" + scene);
    const json simulated = reported("simulate" + scene)["response"];
    BOOST_TEST(report["reference"]["outcome"] == "stopped_in_dead_zone");
    BOOST_TEST(simulated["outcome"] == "stopped_in_dead_zone");
    BOOST_TEST(near(report["reference"]["end_time"], simulated["stop_time"], 1e-15));
    BOOST_TEST(method(report, "stillpoint")["counts_right"] == true);
  }
}

// Friction holds the mass: each of these used to run without end.
BOOST_AUTO_TEST_CASE(says_so_if_nothing_moves) {
  for (const Arguments& still : {Arguments("accuracy --v0 0.1 --p 1 --f 0.1 --delta 0.2"),
                                 Arguments("accuracy --v0 0 --p 1 --f 0.1 --delta 0 --excitation "
                                           "rectangle --k 0.05 --lambda 1")}) {
    const json report = reported(still);
    BOOST_TEST(method(report, "dopri5")["not_run"] == "nothing_moves");
    BOOST_TEST(method(report, "regularised")["not_run"] == "nothing_moves");
    BOOST_TEST(method(report, "stillpoint")["counts_right"] == true);
    BOOST_TEST(contains(run(still).out, "not run: nothing moves"));
  }
}

BOOST_AUTO_TEST_SUITE_END()
