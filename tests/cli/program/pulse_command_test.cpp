// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

BOOST_FIXTURE_TEST_SUITE(pulse_command_test, stillpoint::cli_test::Sandbox)

// design --pulse and region --pulse, from the flags to the report.

using namespace stillpoint::cli_test;

/// A pulse between the ends may leave it farther out than the strongest; the weakest may not move
/// it.
BOOST_AUTO_TEST_CASE(the_notch_that_will_be_built_is_tried_with_every_pulse_of_the_ranges) {
  const Arguments design(
      "design --pulse half-sine --k 0.4g:0.6g --pulse-duration 0.1:0.12 --period 2.6:2.8 "
      "--max-displacement 0.5 --delta-max-m 10mm");
  const json report = reported(design + "--notch-width-m 60mm");
  const json& built = report["built_notch"];
  const json& farthest = built["farthest_rest"];
  const double rest = farthest["response"]["stop_position"];
  BOOST_TEST(farthest["v0"].is_null());
  BOOST_TEST(std::abs(rest) >
             1.1 * std::abs(built["motion"]["response"]["stop_position"].get<double>()));
  Arguments simulate("simulate --excitation half-sine");
  for (const char* const field : {"k", "lambda", "p"}) {
    simulate = simulate + Arguments{std::string("--") + field, in_full(farthest[field])};
  }
  for (const char* const field : {"f", "delta"}) {
    simulate = simulate + Arguments{std::string("--") + field, in_full(report["design"][field])};
  }
  const json motion =
      reported(simulate + Arguments{"--notch-width", in_full(report["design"]["notch_width"])});
  BOOST_TEST(motion["response"]["stop_position"] == rest);

  const Arguments holds = design + "--hold 0.4";
  const json held = finding(reported(holds), "notch_fails");
  BOOST_TEST(held["what"] == "held");
  BOOST_TEST(near(held["k"], 0.4, 1e-12));
  BOOST_TEST(finding(reported(design + "--hold 0.3"), "notch_fails")["what"] != "held");
}

// In metres and seconds as without them, and every way to say how long the pulse is.
BOOST_AUTO_TEST_CASE(a_length_of_a_pulse_may_be_given_as_any_range) {
  const Arguments physical(
      "design --pulse half-sine --k 0.45g:0.55g --period 1.9:2.1 --max-displacement 600mm");
  const json by_duration = reported(physical + "--pulse-duration 0.5s:0.625s");
  const json by_hertz = reported(physical + "--excitation-frequency 0.8:1");
  const json by_lambda = reported(
      physical + Arguments{"--lambda", in_full(by_hertz["input"]["lambda_range"][0]) + ":" +
                                           in_full(by_hertz["input"]["lambda_range"][1])});
  const json& f = by_hertz["design"]["f"];
  BOOST_TEST(near(by_duration["design"]["f"], f.get<double>(), 1e-9));
  BOOST_TEST(near(by_lambda["design"]["f"], f.get<double>(), 1e-9));
  // A half-sine of 0.8 Hz lasts 0.625 s, and the longest period is that of the time unit.
  BOOST_TEST(near(by_hertz["input"]["lambda"], 0.8 * 2.1, 1e-12));
  BOOST_TEST(near(by_hertz["input"]["lambda_range"][1], 1.0 * 2.1, 1e-12));
  BOOST_TEST(near(by_hertz["input"]["p_range"][1], 2.1 / 1.9, 1e-12));
}

/// For a pulse given in seconds the suggested change is in seconds, as it can be given.
BOOST_AUTO_TEST_CASE(a_duration_as_printed_makes_it_feasible) {
  const auto lasting = [](const std::string& duration) {
    return Arguments{"design", "--pulse-duration", duration} +
           "--pulse half-sine --k 0.5g --period 2.8s --max-displacement 20mm";
  };
  const ProgramRun text = ending(3, lasting("70ms"));
  const std::regex figure("pulse duration +at most ([.0-9]+) s\n");
  std::smatch found;
  BOOST_TEST_REQUIRE(std::regex_search(text.out, found, figure), text.out);
  succeed(lasting(found[1].str() + "s"));
  constexpr double beyond = 1 + 1e-4;  // five digits are printed
  BOOST_TEST(run(lasting(in_full(beyond * std::stod(found[1])) + "s")).exit_code == 3);
}

BOOST_AUTO_TEST_SUITE_END()
