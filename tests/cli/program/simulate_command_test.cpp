// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "forced_arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

BOOST_FIXTURE_TEST_SUITE(simulate_command_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;

Arguments simulate(const char* f, const char* delta, const Arguments& more = {}) {
  return Arguments{"simulate", "--v0", "1", "--p", "1", "--f", f, "--delta", delta} + more;
}

/// An instant command gets five seconds, also under sanitizers on a loaded machine.
Surroundings impatient() {
  return {.patience = std::chrono::seconds(5)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_real_notch_and_zones_come_from_flags_and_from_a_scene) {
  const json paper = reported(simulate("0.26", "0.37"));
  check_values(paper["input"],
               {{"hold", nullptr}, {"notch_width", nullptr}, {"friction_zones", nullptr}});
  // docs/notches.md (N3).
  const json built = reported(simulate("0.26", "0.37", "--notch-width 1e-4"));
  BOOST_TEST(built["response"]["outcome"] == "stopped_in_notch");
  BOOST_TEST(built["input"]["notch_width"] == 1e-4);
  BOOST_TEST(std::abs(built["response"]["stop_position"].get<double>() - 0.23537e-4) < 1e-8);

  for (const char* hold : {"0", "0.5"}) {
    const json held = reported(simulate("0.26", "0.37", {"--hold", hold}));
    BOOST_TEST(held["input"]["hold"] == std::stod(hold));
    BOOST_TEST(held["response"] == paper["response"]);  // it takes a load to see the difference
    BOOST_TEST(held["half_cycles"] == paper["half_cycles"]);
  }

  const json flags = reported(simulate("0.1", "0", "--friction-zones 0.1:0.3,0.2:0.4"));
  write("zones.json", R"({"v0": 1, "p": 1, "f": 0.1, "delta": 0,
      "friction_zones": [{"to": 0.1, "f": 0.3}, {"to": 0.2, "f": 0.4}]})");
  const json scene = reported("simulate zones.json");
  BOOST_TEST(scene["input"] == flags["input"]);
  BOOST_TEST(scene["response"] == flags["response"]);
  BOOST_TEST(scene["input"]["friction_zones"][1]["f"] == 0.4);
}

BOOST_AUTO_TEST_CASE(edges_of_zones_and_the_hold_may_carry_their_unit) {
  const Arguments motion("simulate --velocity 0.4 --period 2.8 --f 0.02");
  const Arguments delta("--delta-m 1mm");
  const json bare = reported(motion + delta + "--friction-zones 0.02:0.1,0.05:0.06");
  const json flags = reported(motion + delta + Arguments{"--friction-zones", "20mm:0.1,5 cm:0.06"});
  BOOST_TEST(flags["input"] == bare["input"]);
  write("zones.json", R"({"velocity": 0.4, "period": 2.8, "f": 0.02, "delta_m": 0.001,
      "friction_zones": [{"to": "20mm", "f": 0.1}, {"to": 0.05, "f": 0.06}]})");
  const json scene = reported("simulate zones.json");
  BOOST_TEST(scene["input"] == bare["input"]);
  const json held = reported(motion + delta + "--hold 0.3g");
  BOOST_TEST(held["input"]["hold"] == 0.3);
}

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

// A mass that stops beyond x = 0 has not passed the notch.
BOOST_AUTO_TEST_CASE(a_stop_within_the_notch_counts_crossings) {
  check_values(reported(simulate("0.2", "0.28", "--notch-width 0.1"))["response"],
               {{"half_cycles", 2}, {"turning_points", 2}, {"zero_passages", 1}});
}

// A hit leaves no load, so the notch has nothing to hold, not even one that holds nothing.
BOOST_AUTO_TEST_CASE(what_the_notch_holds_changes_no_design_for_a_hit) {
  const Arguments design("design --v0 1 --p 1 --beta 0.9");
  const json paper = reported(design);
  for (const char* hold : {"0", "0.1"}) {
    const json report = reported(design + Arguments{"--hold", hold});
    BOOST_TEST(report["design"] == paper["design"]);
    const json& built = report["built_notch"];
    BOOST_TEST(report["input"]["hold"] == std::stod(hold));
    BOOST_TEST((report["design"]["notch_width"].is_null() && built["friction"].is_null()));
    BOOST_TEST(built["changes_nothing"] == true);
    BOOST_TEST(built["motion"]["response"]["outcome"] == "stopped_at_zero");
    BOOST_TEST(near(built["motion"]["response"]["stop_time"],
                    motion_of(report)["response"]["stop_time"], 1e-14));
  }
  BOOST_TEST(has_finding(reported(design + "--hold 0.1"), "notch_changes_nothing"));
  // A rectangle above f + hold sets the mass off at once, and is over when it comes back.
  const json at_once =
      reported(Arguments("design --pulse rectangle --k 1.2 --lambda 3.3 --p 1.44"
                         " --beta 0.67 --delta-max 0.62 --hold 0.3"));
  BOOST_TEST(at_once["built_notch"]["changes_nothing"] == true);
  // With a width the mass stops before the middle.
  BOOST_TEST(reported(design + "--notch-width 0.05")["built_notch"]["changes_nothing"] == false);
}

BOOST_AUTO_TEST_CASE(without_friction_it_never_stops_and_says_so_at_once) {
  const json report = reported(simulate("0", "0", "--max-half-cycles 3"), impatient());
  const json& response = report["response"];
  check_values(response, {{"outcome", "never_stops"},
                          {"peak_amplitude", 1},
                          {"peak_acceleration", 1},
                          {"stops_at_zero", false}});
  check_null(response, {"half_cycles", "turning_points", "zero_passages", "stop_time",
                        "stop_position", "arrival_speed", "decision_margin"});
  BOOST_TEST(report["half_cycles_listed"] == 3);
}

BOOST_AUTO_TEST_CASE(counts_beyond_the_integers_of_a_double_are_numbers) {
  const json response = reported(simulate("0", "1e-20"), impatient())["response"];
  BOOST_TEST(near(response["half_cycles"], 5e19, 1e-12));
  BOOST_TEST(near(response["stop_time"], 5e19 * std::numbers::pi, 1e-12));
  // A count that a double holds exactly is written as an integer.
  const ProgramRun exact = run(simulate("0", "4.9e-13", "--json"), impatient());
  BOOST_TEST(contains(exact.out, "\"half_cycles\": 1020408163266,"));
}

BOOST_AUTO_TEST_CASE(limit_of_half_cycles_can_be_set) {
  BOOST_TEST(run(simulate("1e-5", "1e-9", "--half-cycle-limit 1000")).exit_code == 2);
  const json report = reported(simulate("1e-5", "1e-9", "--half-cycle-limit 1e6"));
  BOOST_TEST(report["response"]["half_cycles"].get<double>() > 10'000);
  const Arguments shaken = at_rest("--excitation harmonic --k 0.2 --lambda 1 --t-end 200");
  check_refused(*this, {shaken + "--half-cycle-limit 5",
                        {"half-cycle-limit", "more half-cycles than allowed", "5 by tau"}});
  succeed(shaken + "--half-cycle-limit 100");
}

BOOST_AUTO_TEST_CASE(works_in_metres_and_seconds) {
  const json report = reported(
      "simulate --velocity 0.4 --stiffness 877298.1689857206 --mass 2e5 --f 0.02 --delta-m 0.001");
  const json& quantities = report["physical"];
  const double omega = 2 * std::numbers::pi / 3;
  check_near(quantities,
             {{"period_s", 3},
              {"friction_force_n", 2e5 * 9.80665 * 0.02},
              {"energy_per_passage_j", 2e5 * 9.80665 * 0.001}},
             1e-14);
  // m omega^2 x = spring, m f g = friction: the peak in metres by hand.
  const double offset = 0.02 * 9.80665 / (omega * omega);
  BOOST_TEST(near(quantities["peak_m"], std::hypot(0.4 / omega, offset) - offset, 1e-13));
  const double time_unit = quantities["time_unit_s"];
  BOOST_TEST(near(quantities["stop_time_s"],
                  report["response"]["stop_time"].get<double>() * time_unit, 1e-15));

  const json displaced = reported("simulate --period 3 --x0-m 0.1 --f 0.02 --delta-m 0.001");
  BOOST_TEST(near(displaced["physical"]["peak_m"], 0.1, 1e-15));
  check_null(displaced["physical"], {"friction_force_n", "energy_per_passage_j"});
}

BOOST_AUTO_TEST_CASE(figures_beyond_a_double_are_refused_or_left_out_but_never_infinite) {
  const Arguments enormous(
      "simulate --velocity 1 --period 1 --mass 1e30 --gravity 1e30 --f 1 --delta-m 1e260");
  check_only_finite(run(enormous).out);
  const ProgramRun answer = run(enormous + "--json");
  BOOST_TEST((answer.exit_code == 0 || answer.exit_code == 2));
}

BOOST_AUTO_TEST_SUITE_END()
