// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <fmt/format.h>

#include <stillpoint/report/digits.hpp>

#include <algorithm>
#include <numbers>
#include <regex>

BOOST_AUTO_TEST_SUITE(record_design_command_test)

// design --record, from the flags to the report. The search itself is in record_design_test.

namespace {

using namespace stillpoint::cli_test;

/// Of a figure worked out by hand, after its way through metres.
constexpr double hand_tolerance = 1e-12;

/// A damper that does not move, so every figure is known: it transmits the load.
const Arguments held("design --record a.txt --period 2.8s --search-f 2:2 --search-delta-m 0:0");

/// A search under it takes seconds.
const Arguments long_search(
    "design --record long.txt --record-step 0.01 --period 2.8 --hold 0.1 --jump-max 9");
std::string long_record(int shaken = 18'900) {
  std::string record;
  for (int i = 0; i < shaken + 1100; ++i) {
    // Without an offset, and quiet at its end.
    record += i >= shaken ? "0\n" : i % 7 < 3 ? "0.3\n" : "-0.225\n";
  }
  return record;
}

json failed_report(const Sandbox& sandbox, const Arguments& arguments, int exit_code) {
  const ProgramRun answer = sandbox.run(arguments + "--json");
  BOOST_TEST(answer.exit_code == exit_code, answer.err);
  return answer.json();
}

}  // namespace

BOOST_FIXTURE_TEST_CASE(a_damper_that_does_not_move_transmits_the_load, Recorded) {
  // As a spreadsheet may save it.
  write("list.csv", "\xEF\xBB\xBF\"file\", scale\r\n\"a.txt\" , -3 \r\n# a comment\r\n \r\n");
  for (const auto& [combine, load] : {std::pair{"max", 1.2}, {"mean", 0.8}}) {
    const json report =
        reported(held + "--records-list list.csv" + Arguments{"--combine", combine});
    check_values(report["design"], {{"f", 2}, {"delta_m", 0}});
    BOOST_TEST(near(report["design"]["period_s"], 2.8, hand_tolerance));
    BOOST_TEST(report["input"]["objective"] == "acceleration");
    BOOST_TEST(report["cases"][0]["combine"] == combine);
    BOOST_TEST(
        near(report["cases"][0]["worst"]["peak_absolute_acceleration"], load, hand_tolerance));
    BOOST_TEST(report["cross_check"]["passed"] == true);
  }
}

// m f g = 1000 kg x 0.3 x 9.80665 m/s2 and m g Delta = 1000 kg x 9.80665 m/s2 x 1 mm.
BOOST_FIXTURE_TEST_CASE(a_mass_gives_the_force_and_the_energy_of_the_damper, Recorded) {
  const Arguments asked(
      "design --record a.txt --period 2.8s --search-f 0.3:0.3 --search-delta-m 1mm:1mm "
      "--notch-width-m 20mm");
  const json with = run(asked + "--mass 1t --json").json()["physical"];
  constexpr double few_ulps = 1e-14;
  BOOST_TEST(std::abs(with["friction_force_n"].get<double>() / 2941.995 - 1) <= few_ulps);
  BOOST_TEST(std::abs(with["energy_per_passage_j"].get<double>() / 9.80665 - 1) <= few_ulps);
  const json without = run(asked + "--json").json()["physical"];
  BOOST_TEST(without["friction_force_n"].is_null());
  BOOST_TEST(without["energy_per_passage_j"].is_null());
}

BOOST_FIXTURE_TEST_CASE(records_may_be_dimensionless, Recorded) {
  const json report =
      reported("design --record a.txt --p 1 --beta 1 --search-f 2:2 --residual 0.1");
  BOOST_TEST(report["design"]["delta_m"] == nullptr);
  BOOST_TEST(near(report["cases"][0]["worst"]["peak_absolute_acceleration"], 0.4, hand_tolerance));
}

BOOST_FIXTURE_TEST_CASE(a_step_is_for_the_records_without_one, Recorded) {
  write("values.txt", "0\n0.9\n0\n");
  const json report = reported(held + "--record values.txt --record-step 0.5");
  BOOST_TEST(near(motion_of(report)["pga"], 0.4, hand_tolerance));
  BOOST_TEST(near(report["cases"][0]["motions"][1]["pga"], 0.9, hand_tolerance));
}

BOOST_FIXTURE_TEST_CASE(the_report_matches_simulate, Recorded) {
  const json report = reported(
      "design --record a.txt --period 2.8 --max-displacement 0.3 --residual-m 5mm --hold 0.1 "
      "--jump-max 2");
  const json& design = report["design"];
  const json motion =
      reported({"simulate", "--record", "a.txt", "--period", "2.8", "--hold", "0.1", "--f",
                in_full(design["f"]), "--delta-m", in_full(design["delta_m"])});
  const json& response = motion["response"];
  BOOST_TEST(
      near(report["cases"][0]["nominal"]["peak_amplitude"], response["peak_amplitude"], 1e-9));
  BOOST_TEST(near(report["cases"][0]["nominal"]["peak_absolute_acceleration"],
                  response["peak_absolute_acceleration"], 1e-9));
  BOOST_TEST(report["cases"][0]["worst"]["peak_amplitude"] >=
             report["cases"][0]["nominal"]["peak_amplitude"]);
  const json& worst = report["cases"][0]["worst"]["of"]["peak_amplitude"];
  const json at_worst =
      reported({"simulate", "--record", "a.txt", "--period", "2.8", "--hold", "0.1", "--f",
                in_full(worst["f"]), "--delta-m", in_full(worst["delta_m"])});
  BOOST_TEST(near(report["cases"][0]["worst"]["peak_amplitude"],
                  at_worst["response"]["peak_amplitude"], 1e-9));
  BOOST_TEST(motion_of(report)["response"]["outcome"] == response["outcome"]);
  BOOST_TEST(report["cases"][0]["worst"]["peak_m"].get<double>() <= 0.3);
  BOOST_TEST(report["cases"][0]["worst"]["residual_m"].get<double>() <= 0.005);
  const json& box = design["box"];
  BOOST_TEST(box["samples"].get<int>() >= 4000);
  BOOST_TEST(box["exact"] == false);
  BOOST_TEST(near(box["f"][0], 0.9 * design["f"].get<double>(), hand_tolerance));
  BOOST_TEST(box["period_s"].is_null());
  BOOST_TEST(near(report["input"]["residual_m"], 0.005, hand_tolerance));
}

BOOST_FIXTURE_TEST_CASE(the_period_is_a_third_variable, Recorded) {
  const json report = reported(
      "design --record a.txt --search-period 1s:3s --search-f 2:2 "
      "--search-delta-m 0:1mm --jump-max 1 --threads 1");
  BOOST_TEST(report["design"]["period_s"].get<double>() >= 1 - hand_tolerance);
  BOOST_TEST(report["design"]["period_s"].get<double>() <= 3 + hand_tolerance);
}

BOOST_FIXTURE_TEST_CASE(without_a_damper_it_says_which_limit_is_in_the_way, Recorded) {
  const json report =
      failed_report(*this, held + "--max-displacement 10mm --acceleration-max 0.1", 3);
  BOOST_TEST(report["design"] == nullptr);
  BOOST_TEST(report["verdict"].is_string());
  const json& limits = report["constraints"];
  BOOST_TEST_REQUIRE(limits.size() == 2U);
  check_values(limits[0], {{"name", "amplitude"}, {"relation", "<="}, {"motion", "a.txt"}});
  check_values(limits[1], {{"name", "acceleration"}, {"satisfied", false}});
  BOOST_TEST(near(limits[1]["value"], 0.4, hand_tolerance));
  BOOST_TEST(near(limits[0]["limit_m"], 0.01, hand_tolerance));
  check_null(limits[1], {"value_m", "limit_m"});
  BOOST_TEST_REQUIRE(report["mends"].size() == 1U);
  BOOST_TEST(report["mends"][0]["input"] == "acceleration_max");
  const std::string relaxed = in_full(report["mends"][0]["value"]);
  succeed(held + Arguments{"--max-displacement", "10mm", "--acceleration-max", relaxed});
}

BOOST_FIXTURE_TEST_CASE(a_damper_without_friction_is_reported_never_to_rest, Recorded) {
  const json report = failed_report(*this,
                                    "design --record a.txt --period 2.8 --search-f 0:0 "
                                    "--search-delta-m 0:0 --max-displacement 1",
                                    3);
  BOOST_TEST(report["nearest"]["worst"] == nullptr);
  BOOST_TEST_REQUIRE(report["constraints"].size() == 1U);
  check_null(report["constraints"][0], {"value", "value_m", "slack"});
}

BOOST_FIXTURE_TEST_CASE(a_scene_lists_its_records, Recorded) {
  write("b.txt", "0 0.1\n1 0\n");
  write("scene.json",
        R"({"record": ["a.txt", "b.txt"], "period": "2.8s", "search_f": "2:2",
            "search-delta-m": "0:0mm"})");
  BOOST_TEST(reported("design scene.json")["cases"][0]["motions"].size() == 2U);
  BOOST_TEST(reported("design scene.json --record b.txt")["cases"][0]["load"]["records"] == 1);
  // For a hit, the records are those of another command.
  const ProgramRun hit = run("design scene.json --velocity 0.4 --max-displacement 0.15 --json");
  BOOST_TEST(hit.json()["schema"] == "stillpoint/design-report/2");
  BOOST_TEST(contains(hit.err, "note: record in the scene is not used by design"), hit.err);
}

BOOST_FIXTURE_TEST_CASE(an_interrupt_ends_with_the_best_so_far, Sandbox) {
  write("long.txt", long_record());
  const Surroundings interrupted{.interrupt = true};
  const ProgramRun stopped = ending(130, long_search + "--json --output r.json", interrupted);
  BOOST_TEST(stopped.err ==
             "stillpoint: caution: The search was interrupted: a complete one may find a better "
             "damper.\n");
  BOOST_TEST(stopped.json()["search"]["interrupted"] == true);
  BOOST_TEST(stopped.json()["search"]["scan"]["points"] < 10'000);
  BOOST_TEST(read("r.json") == stopped.out);
  BOOST_TEST(contains(run(long_search, interrupted).out,
                      "No damper was verified before the search was interrupted."));
}

// Friction alone is verified in a second; the notch of any width, at any period, takes a minute.
BOOST_FIXTURE_TEST_CASE(an_interrupt_gives_the_verified_damper_that_a_terminal_shows, Sandbox,
                        *boost::unit_test::precondition(if_terminals)) {
  write("shorter.txt", long_record(2'900));
  const Arguments search(
      "design --record shorter.txt --record-step 0.01 --search-period 2:4 --residual-m 0.05 "
      "--search-notch-width-m 20mm:300mm --scan-points 1000000");
  const std::string mark = ", best verified ";
  const Surroundings interrupted{.error_is_terminal = true, .interrupt_at = mark};
  const ProgramRun stopped = ending(130, search + "--json --output r.json", interrupted);
  check_contains(stopped.err, {" of about ", " dampers"});
  const json report = stopped.json();
  BOOST_TEST(report["search"]["interrupted"] == true);
  BOOST_TEST(report["design"]["box"]["samples"] >= 4000);
  BOOST_TEST(report["cases"][0]["worst"]["residual_m"] <= 0.05);
  BOOST_TEST(read("r.json") == stopped.out);

  const ProgramRun again = ending(130, search, interrupted);
  const std::string best = again.err.substr(again.err.rfind(mark) + mark.size());
  const std::string transmitted = best.substr(0, best.find(','));  // "0.24 g transmitted"
  BOOST_TEST(contains(one_line(again.out), " " + transmitted), again.out);
}

BOOST_AUTO_TEST_SUITE_END()
