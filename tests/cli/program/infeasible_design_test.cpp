// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <algorithm>
#include <numbers>

BOOST_FIXTURE_TEST_SUITE(infeasible_design_test, stillpoint::cli_test::Sandbox)

// What design says if no damper is admissible.

namespace {

using namespace stillpoint::cli_test;
using right::design;

}  // namespace

BOOST_AUTO_TEST_CASE(says_why_and_what_would_help) {
  const ProgramRun run_of_json = ending(3, design(0.6, "--json"));
  BOOST_TEST(run_of_json.err.empty(), run_of_json.err);
  const json report = run_of_json.json();
  BOOST_TEST(report["region"]["feasible"] == false);
  const auto reason = report["region"]["reason"].get<std::string>();
  check_contains(reason, {"f >= 0.533334", "f <= 0.353553"});
  check_null(report["region"], {"f_lower", "f_upper"});
  check_null(report, {"design", "search", "cross_check", "physical"});
  BOOST_TEST(report["cases"][0]["motions"].empty());
  BOOST_TEST(report["constraints"].empty());

  // f2 at most f3: V0 (1/beta - beta)/2 <= V0/sqrt(8) for each of the three alone.
  for (const json& mend : report["mends"]) {
    BOOST_TEST(near(mend["value"],
                    mend["input"] == "v0"  ? 0.6 * std::numbers::sqrt2
                    : mend["input"] == "p" ? 1 / (0.6 * std::numbers::sqrt2)
                                           : 1 / std::numbers::sqrt2,
                    1e-12));
  }
  BOOST_TEST(report["mends"].size() == 3U);
  // Where beta does not help, what a designer can choose, not the hit; in the terms given.
  for (const auto& [task, input] :
       {std::pair{"design --v0 1 --p 1 --beta 0.9 --delta-max 0.01", "delta_max"},
        {"design --v0 1 --p 1 --beta 0.9 --acceleration-max 0.9", "acceleration_max"},
        {"design --v0 0.1:0.4 --p 1 --beta 0.36", "v0_high"}}) {
    const json mends = ending(3, Arguments(task) + "--json").json()["mends"];
    BOOST_TEST(std::ranges::any_of(mends, [&](const json& mend) { return mend["input"] == input; }),
               input << " in " << mends.dump());
  }
}

// (f3 - f2)/(f3 + f2) = 22.22 % with f2 = 0.225, f3 = 1/sqrt(8), at their middle.
BOOST_AUTO_TEST_CASE(says_the_largest_tolerance_beside_a_single_mend) {
  const Arguments too_much = design(0.8, "--tolerance 0.4");
  const Arguments same = "region" + Arguments(too_much.begin() + 1, too_much.end());
  for (const Arguments& command : {too_much, same}) {
    const json report = run(command + "--json").json();
    const json& region = report["region"];
    BOOST_TEST(near(region["most_tolerant"]["tolerance"], 0.22219797, 1e-7));
    BOOST_TEST(near(region["most_tolerant"]["f"], 0.28927670, 1e-7));
    BOOST_TEST(report["mends"].size() == 1U);
  }
  const json other_fault = run(design(0.6, "--tolerance 0.1 --json")).json()["region"];
  BOOST_TEST(other_fault["most_tolerant"].is_null());
}

// (f3 - f2)/(0.2 f3 + 0.2 f2) of 0.2, and a quarter of it for Delta, as they can be asked for.
BOOST_AUTO_TEST_CASE(a_two_sided_tolerance_is_mended_on_each_side) {
  const Arguments too_much = design(0.75, "--tolerance-f 0.8:1.2 --tolerance-delta 0.05");
  ending(3, too_much);
  succeed(design(0.75, "--tolerance-f 0.09591 --tolerance-delta 0.02397"));
}

/// A tolerance that no damper has gets an explanation: the theory's largest is 36.3 %.
BOOST_AUTO_TEST_CASE(says_the_largest_tolerance_where_no_input_is_enough) {
  const Arguments impossible = design(0.6, "--tolerance 0.5");
  const json report = run(impossible + "--json").json();
  BOOST_TEST(near(report["largest_tolerance"], 0.36336, 1e-4));
  BOOST_TEST(report["mends"].empty());
  BOOST_TEST(run(design(0.6, "--json")).json()["largest_tolerance"].is_null());
  const Arguments pulse(
      "design --pulse half-sine --k 0.5 --lambda 20 --p 1 --beta 0.02 --tolerance 0.5 --json");
  // With a pulse nothing bounds Delta, so that a weaker one alone is enough.
  const json by_pulse = run(pulse).json();
  BOOST_TEST(by_pulse["largest_tolerance"].is_null());
  BOOST_TEST(by_pulse["mends"][0]["input"] == "k");
}

/// From f3 = 0.35355 on the mass does not come back and rests at 3 f - S. The box of 10 % begins
/// there: f = 0.39284, and its other end, 0.43212, rests at 0.20699.
BOOST_AUTO_TEST_CASE(constant_friction_alone_is_a_task) {
  const Arguments task = design(0.85, "--criterion exact --tolerance 0.1 --delta-max 0");
  ending(3, task);
  const json report = reported(task + "--residual 0.207");
  const double f = report["design"]["f"];
  BOOST_TEST(near(f, 0.39284, 1e-4));
  BOOST_TEST(report["design"]["delta"] == 0);
  BOOST_TEST(
      near(motion_of(report)["response"]["stop_position"], 3 * f - std::sqrt(1 + f * f), 1e-12));
  // Parts without a notch, each within its f/p^2 of x = 0.
  write("parts.csv", "name,f,delta\nplain,0.1,0\n");
  const Arguments parts = design(0.95, "--arrivals 10 --catalogue parts.csv");
  ending(3, parts + "--residual 0.001");
  BOOST_TEST(reported(parts + "--residual 0.1")["cross_check"]["passed"] == true);
}

BOOST_AUTO_TEST_CASE(names_the_limit_that_is_in_the_way) {
  struct Case {
    Arguments limit;
    std::string name;
    std::string words;
  };
  for (const auto& [limit, name, words] :
       {Case{{"--f-max", "0.1"}, "f_max", "f may be at most 0.1"},
        Case{{"--delta-max", "0.01"}, "delta_max", "delta may be at most 0.01"},
        Case{{"--tolerance", "0.4"}, "tolerance", "a tolerance of 40 %"}}) {
    const ProgramRun answer = ending(3, design(0.9, "--json" + limit));
    const json report = answer.json();
    BOOST_TEST(contains(report["region"]["reason"].get<std::string>(), words));
    bool mended = false;
    for (const json& mend : report["mends"]) {
      mended = mended || mend["input"] == name;
    }
    BOOST_TEST(mended, name);
  }
}

// Delta1 at f3 is 1/16 published and 0 exact: delta <= 0.05 leaves a damper only with the latter.
// For a pulse and for the parts of a catalogue as well.
BOOST_AUTO_TEST_CASE(offers_the_exact_criterion_where_it_mends) {
  write("parts.csv", "name,f,delta\nA,0.35,0.05\n");
  const Arguments delta("--delta-max 0.05");
  const std::vector<Arguments> tasks{
      design(2) + delta, Arguments("region --v0 1 --p 1 --beta 2") + delta,
      design(2) + Arguments("--catalogue parts.csv"),
      Arguments("design --pulse rectangle --k 20 --lambda 62.83 --p 1 --beta 2 --delta-max 0.05")};
  for (const Arguments& task : tasks) {
    BOOST_TEST(run(task + "--json").json()["region"]["criterion_mend"] == "exact");
    const ProgramRun exact = run(task + "--criterion exact --json");
    BOOST_TEST(exact.exit_code == 0, exact.err);
    BOOST_TEST(exact.json()["region"]["criterion_mend"].is_null());
  }
  BOOST_TEST(run(design(0.6, "--json")).json()["region"]["criterion_mend"].is_null());
}

BOOST_AUTO_TEST_CASE(report_is_still_written_to_a_file) {
  BOOST_TEST(run(design(0.6, "--output report.json")).exit_code == 3);
  BOOST_TEST(json::parse(read("report.json"))["region"]["feasible"] == false);
}

BOOST_AUTO_TEST_CASE(wrong_input_comes_before_an_empty_region) {
  BOOST_TEST(run(design(0.6, "--objective best")).exit_code == 2);
  BOOST_TEST(run(design(0.6, "--algorithm LD_BEST")).exit_code == 2);
}

// From a peak just beyond the dead zone the mass slips by next to nothing, and late.
BOOST_FIXTURE_TEST_CASE(the_stroke_that_a_residual_asks_for_makes_a_design, Sandbox) {
  BOOST_TEST(
      contains(run("design --v0 1 --p 1 --beta 0.5 --residual 0.6").out, "at least 0.57736"));
  BOOST_TEST(run("design --v0 1 --p 1 --beta 0.57736 --residual 0.6").exit_code == 0);
}

BOOST_AUTO_TEST_SUITE_END()
