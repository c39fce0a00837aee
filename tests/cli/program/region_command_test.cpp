// SPDX-License-Identifier: MIT
#include "cli_test.hpp"

#include <regex>

BOOST_FIXTURE_TEST_SUITE(region_command_test, stillpoint::cli_test::Sandbox)

namespace {

using namespace stillpoint::cli_test;

Arguments region(const Arguments& more = {}) {
  return "region --v0 1 --p 1 --beta 0.8" + more;
}

}  // namespace

BOOST_AUTO_TEST_CASE(huge_friction_is_refused_or_reported_in_finite_numbers) {
  for (const char* f : {"1e150", "1e300"}) {
    const Arguments arguments = region({"--f", f, "--delta", "1"});
    const ProgramRun text = run(arguments);
    check_only_finite(text.out);
    if (text.exit_code == 2) {
      BOOST_TEST(contains(text.err, "f = "), text.err);
      continue;
    }
    check_null(reported(arguments), {"delta1_exact"});
  }
}

/// A suggested change is in the terms given: for a stiffness it is a stiffness.
BOOST_AUTO_TEST_CASE(mends_name_the_stiffness_if_it_was_given) {
  const auto isolator = [](const std::string& stiffness) {
    return Arguments{"region", "--velocity", "0.4", "--stiffness", stiffness, "--max-displacement",
                     "0.1",    "--mass",     "1e5"};
  };
  // beta p / V0 = X omega / v = 1/sqrt 2, (10), so that k = m v^2 / (2 X^2).
  const json quantities = run(isolator("6e5") + "--json").json()["physical"];
  const double mended = quantities["stiffness_mend_n_per_m"];
  constexpr double digits = 1e-13;  // to the safe side
  BOOST_TEST(near(mended, 1e5 * 0.16 / 0.02, digits));
  succeed(isolator(in_full(mended)));
  BOOST_TEST(run(isolator(in_full(mended * (1 - 1e-12)))).exit_code == 3);

  const Arguments by_period("region --velocity 0.4 --period 2.5651 --max-displacement 0.1");
  const json without_mass = run(by_period + "--json").json()["physical"];
  check_null(without_mass, {"stiffness_mend_n_per_m"});
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
