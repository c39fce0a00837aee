// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fmt/format.h>

BOOST_FIXTURE_TEST_SUITE(simulate_command_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;

BOOST_AUTO_TEST_CASE(a_design_is_simulated_with_the_notch_that_will_be_built) {
  const Arguments design("design --velocity 0.4 --period 2.8 --max-displacement 0.15");
  BOOST_TEST(reported(design)["built_notch"].is_null());
  const json report = reported(design + "--notch-width-m 0.02");
  const json& built = report["built_notch"];
  BOOST_TEST(built["motion"]["response"]["outcome"] == "stopped_in_notch");
  BOOST_TEST(near(report["design"]["notch_width_m"], 0.02, 1e-14));
  BOOST_TEST(std::abs(built["motion"]["physical"]["stop_position_m"].get<double>()) <= 0.01);
  // It leaves freely, so the peak is the design's; the notch is felt, f + delta/w at most.
  BOOST_TEST(near(built["motion"]["response"]["peak_amplitude"],
                  motion_of(report)["response"]["peak_amplitude"], 1e-14));
  const double inside =
      report["design"]["f"].get<double>() +
      report["design"]["delta"].get<double>() / report["design"]["notch_width"].get<double>();
  BOOST_TEST(near(built["friction"], inside, 1e-14));
  BOOST_TEST(built["motion"]["response"]["peak_absolute_acceleration"].get<double>() >
             0.9 * inside);
  BOOST_TEST(built["farthest_rest"].is_null());

  // One that acts on the way out too is a zone of that friction.
  const json& strip = built["from_start"];
  const json zone = reported(Arguments(
      fmt::format(
          "simulate --velocity 0.4 --period 2.8 --delta-m 0 --f {} --friction-zones 10mm:{}",
          report["design"]["f"].get<double>(), built["friction"].get<double>())
          .c_str()));
  BOOST_TEST(near(strip["response"]["peak_amplitude"], zone["response"]["peak_amplitude"], 1e-12));
  BOOST_TEST(near(strip["response"]["stop_position"], zone["response"]["stop_position"], 1e-9));
}

BOOST_AUTO_TEST_CASE(counts_beyond_the_integers_of_a_double_are_numbers) {
  // At once: five seconds, also under sanitizers on a loaded machine. A count that a double holds
  // exactly is written as an integer.
  const Surroundings impatient{.patience = std::chrono::seconds(5)};
  const Arguments motion("simulate --v0 1 --p 1 --f 0 --json --delta");
  succeed(motion + "0", impatient);
  succeed(motion + "1e-20", impatient);
  const ProgramRun exact = succeed(motion + "4.9e-13", impatient);
  BOOST_TEST(contains(exact.out, "\"half_cycles\": 1020408163266,"));
}

BOOST_AUTO_TEST_CASE(figures_beyond_a_double_are_refused_or_left_out_but_never_infinite) {
  const Arguments enormous(
      "simulate --velocity 1 --period 1 --mass 1e30 --gravity 1e30 --f 1 --delta-m 1e260");
  check_only_finite(run(enormous).out);
  const ProgramRun answer = run(enormous + "--json");
  BOOST_TEST((answer.exit_code == 0 || answer.exit_code == 2));
}

/// What the mass feels where it crosses a whole notch, followed by simulate with its edges.
BOOST_AUTO_TEST_CASE(the_bound_of_the_notch_is_what_a_passage_feels) {
  const Arguments damper("--velocity 0.4 --period 2.8 --f 0.01 --delta-m 3mm");
  const std::string text =
      std::regex_replace(run(Arguments("region --max-displacement 0.2 --arrivals 2") + damper).out,
                         std::regex("\\s+"), " ");
  std::smatch found;
  BOOST_TEST_REQUIRE(
      std::regex_search(text, found, std::regex("at most ([0-9.]+) g inside one 20 mm wide")),
      text);
  const double stated = std::stod(found[1]);
  const double felt = reported(Arguments("simulate --notch-width-m 20mm") +
                               damper)["response"]["peak_absolute_acceleration"];
  BOOST_TEST(felt <= stated);
  BOOST_TEST(felt > stated - 0.001);
}

BOOST_AUTO_TEST_SUITE_END()
