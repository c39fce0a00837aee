// SPDX-License-Identifier: MIT
#include "cli_test.hpp"
#include "wrong_arguments.hpp"

#include <stillpoint/answers/exit_code.hpp>
#include <stillpoint/design/cross_check.hpp>
#include <stillpoint/design/design.hpp>
#include <stillpoint/report/report.hpp>

BOOST_FIXTURE_TEST_SUITE(design_command_test, stillpoint::cli_test::Sandbox)

using namespace stillpoint::cli_test;
using right::design;

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

BOOST_AUTO_TEST_CASE(is_the_same_json_in_a_file) {
  const ProgramRun text = succeed(design(0.9, "--output report.json"));
  BOOST_TEST(text.out.starts_with("Damper design"));
  const std::string written = read("report.json");
  BOOST_TEST(without_wall_times(json::parse(written)) == without_wall_times(reported(design(0.9))));
  BOOST_TEST(contents().size() == 1U);

  const ProgramRun both = run(design(0.9, "--json --output report.json"));
  BOOST_TEST(read("report.json") == both.out);
  BOOST_TEST(run(design(0.6, "--output report.json")).exit_code == 3);  // also without a damper
  BOOST_TEST(json::parse(read("report.json"))["region"]["feasible"] == false);
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
}

BOOST_AUTO_TEST_SUITE_END()
