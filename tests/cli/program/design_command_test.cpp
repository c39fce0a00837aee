// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <stillpoint/answers/exit_code.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/report/report.hpp>

BOOST_FIXTURE_TEST_SUITE(design_command_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;
using right::design;

}  // namespace

/// After several arrivals a requirement bounds v0; the table is in the units of the figures.
BOOST_AUTO_TEST_CASE(the_table_of_constraints_is_in_the_units_of_the_task) {
  const Arguments later("--arrivals 2 --f-max 0.01 --verbose");
  const Arguments built("design --velocity 0.4 --period 2.8 --max-displacement 0.2");
  check_contains(run(built + later).out, {"v0 < 0.4898", " m/s   met\n", " mm   met\n"});
}

/// f from 0.3535533774 to 0.3535533906: no six digits lie in between.
BOOST_AUTO_TEST_CASE(a_friction_and_its_limits_have_the_digits_that_keep_them_apart) {
  const ProgramRun narrow = run(Arguments("design --v0 1 --p 1 --beta 0.70710679 --verbose"));
  check_contains(narrow.out, {"The damper found has f = 0.35355338 and delta = 0.28125: ",
                              "damper            f = 0.35355338, delta = 0.28125\n",
                              "f >= 0.35355338 ", "f <= 0.35355339 "});
}

/// The best is the limit f -> 0, which nobody builds: the text says so, the JSON has the point.
BOOST_AUTO_TEST_CASE(next_to_no_friction_is_said_in_words) {
  const Arguments task("--arrivals 2 --f-max 0.1");
  BOOST_TEST(reported(design(1.1, task))["design"]["f"] < 1e-6);
  const std::string shown = run(design(1.1, task)).out;
  check_contains(shown, {"Build delta = 0.375 and as little constant friction as you can: ",
                         "damper            f as small as you can make it, delta = 0.375",
                         "delta may be off by +-33.33 % with next to no f"});
  const json least = finding(reported(design(1.1, task)), "least_friction_is_best");
  BOOST_TEST(near(least["f"], 0.00621, 1e-2));
  BOOST_TEST(least["tolerance"] == 0.3);
  BOOST_TEST(shown.find("e-09") == std::string::npos, shown);
  // It passes x = 0 from 1 to sqrt(1 - 2 Delta) = 0.5, and stops on the next return.
  check_contains(run(design(1.1, task) + "--verbose").out, {"Half-cycles\n"});
  for (const json& impulse : reported(design(1.1, task))["practice"]["impulses"]) {
    BOOST_TEST(near(impulse, 0.5, 1e-6));
  }
  // Delta must be V0^2/2 where there is no friction: Delta1 = Delta2.
  const std::string exact = run(design(1.1, "--objective time")).out;
  check_contains(exact, {"Build delta = 0.5 and as little constant friction as you can: ",
                         "v0 of exactly 1\n"});
  check_contains(one_line(exact), {"tolerance f or delta must be exact: the damper is within a "
                                   "millionth of an edge of the admissible region "});
}

// What a script reads as the tolerance of both frictions must not be more than that.
BOOST_AUTO_TEST_CASE(echoes_tolerances_of_each_side) {
  const auto echoed = [&](const char* options) {
    const json input = reported(design(0.95, Arguments(options)))["input"];
    return json{input["tolerance"], input["tolerance_f"], input["tolerance_delta"]};
  };
  BOOST_TEST(echoed("--tolerance-f 0.75:1.25") == json({0, {0.75, 1.25}, {1, 1}}));
  BOOST_TEST(echoed("--tolerance 0.125 --tolerance-f 0.25") ==
             json({0.125, {0.75, 1.25}, {0.875, 1.125}}));
  BOOST_TEST(echoed("--tolerance 0.125 --tolerance-f 0.875:1") ==
             json({0, {0.875, 1}, {0.875, 1.125}}));
}

/// The rows are those that `region` lists for the same point.
BOOST_AUTO_TEST_CASE(given_limits_have_rows) {
  const Arguments limits("--f-max 0.3 --delta-max 0.45");
  const json report = reported(design(0.9, limits));
  const json again = reported(Arguments{"region", "--v0", "1", "--p", "1", "--beta", "0.9", "--f",
                                        in_full(report["design"]["f"]), "--delta",
                                        in_full(report["design"]["delta"])} +
                              limits);
  BOOST_TEST(report["constraints"].size() == 7U);
  BOOST_TEST(report["constraints"] == again["constraints"]);
}

BOOST_AUTO_TEST_CASE(for_people_names_every_part) {
  const ProgramRun text = succeed(design(0.9, {"--title", "the bridge at noon", "--verbose"}));
  BOOST_TEST(text.err.empty(), text.err);
  check_only_finite(text.out);
  check_contains(text.out, {"the bridge at noon", "0.259325", "0.36674", "36.33 %", "dead zone",
                            "start", "amplitude", "return", "stop", "half-cycle map", "Runge-Kutta",
                            "LD_SLSQP", "published", "robust"});
  BOOST_TEST(text.out.find('{') == std::string::npos);
}

BOOST_AUTO_TEST_CASE(is_the_same_json_in_a_file) {
  const ProgramRun text = succeed(design(0.9, "--output report.json"));
  BOOST_TEST(text.out.starts_with("Damper design"));
  const std::string written = read("report.json");
  BOOST_TEST(without_wall_times(json::parse(written)) == without_wall_times(reported(design(0.9))));
  BOOST_TEST(contents().size() == 1U);

  const ProgramRun both = run(design(0.9, "--json --output report.json"));
  BOOST_TEST(read("report.json") == both.out);
}

/// The report is still printed.
BOOST_AUTO_TEST_CASE(a_failed_cross_check_is_exit_code_4_with_a_report) {
  const stillpoint::design::Problem problem{1, 1, 0.8};
  auto result = stillpoint::design::design({problem});
  const auto& [f, delta, tolerance] = result.finding.value().point;
  auto wrong = stillpoint::design::predict(problem, f);
  wrong.peak_amplitude *= 1 + 1e-6;
  result.finding->cross_check = stillpoint::design::cross_check(wrong, problem, f, delta);
  const stillpoint::report::DesignReport failed{result};
  BOOST_TEST(stillpoint::answers::exit_code(failed) == 4);
  const auto check = stillpoint::report::json(failed)["cross_check"];
  BOOST_TEST(check["passed"] == false);
  BOOST_TEST(check["methods"][0]["passed"] == false);
  BOOST_TEST(contains(stillpoint::report::text(document(failed)), "DISAGREE"));
}

BOOST_AUTO_TEST_SUITE_END()
