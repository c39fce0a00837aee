// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(accuracy_command_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

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

BOOST_AUTO_TEST_SUITE_END()
